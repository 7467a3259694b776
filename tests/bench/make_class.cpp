// make_class starter|wild|typical COUNT SEED SUBMISSIONS OUT: makes a class of distinct programs for timing from the
// sample submissions, right ones but in a typical class. In a *starter* class every program begins with one of four
// include blocks, as if the course shipped starter files. In a *wild* class each program has its own block: headers in
// a different order, more headers, and a #define. In a *typical* class 70 of 100 programs begin with one of the four
// blocks and 30 with their own, 60 warn, 5 don't compile and 3 never end. Helper functions with different numbers make
// the programs distinct.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Program {
    std::vector<std::string> defines, includes;
    std::string body;
};

Program read(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("can't read " + file.string());
    Program program;
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("#define", 0) == 0) {
            program.defines.push_back(line);
        } else if (line.rfind("#include", 0) == 0) {
            program.includes.push_back(line);
        } else {
            program.body += line + '\n';
        }
    }
    return program;
}

std::string block_of(const Program& program) {
    std::string text;
    for (const std::string& line : program.defines) text += line + '\n';
    for (const std::string& line : program.includes) text += line + '\n';
    return text;
}

/// Some twenty lines that no other student has.
std::string own_helpers(std::size_t student, std::mt19937& random) {
    const auto number = [&] { return std::to_string(random() % 1000) + "." + std::to_string(random() % 1000) + "f"; };
    std::ostringstream text;
    for (int i = 0; i < 3; ++i) {
        text << "float helper_" << student << '_' << i
             << "(const glm::vec3& p, float x)\n{\n    float sum = " << number() << ";\n    for (int k = 0; k < "
             << 2 + random() % 9 << "; ++k)\n        sum += x * " << number() << " + glm::dot(p, glm::vec3(" << number()
             << ", " << number() << ", " << number() << "));\n    return sum;\n}\n\n";
    }
    return text.str();
}

std::string own_block(Program program, std::size_t student, std::mt19937& random) {
    std::array<const char*, 9> further{"algorithm", "array",  "cassert", "cstdlib", "iomanip",
                                       "limits",    "string", "utility", "vector"};
    std::shuffle(further.begin(), further.end(), random);
    for (std::size_t i = 0; i < random() % 3; ++i)
        program.includes.push_back("#include <" + std::string(further.at(i)) + ">");
    std::shuffle(program.includes.begin(), program.includes.end(), random);
    // The place among the headers varies, so that pairs of blocks share beginnings of different lengths.
    const auto place = program.includes.begin() + static_cast<std::ptrdiff_t>(random() % (program.includes.size() + 1));
    program.includes.insert(place, "#define STUDENT " + std::to_string(student));
    return block_of(program);
}

/// A function that g++ -Wall -Wextra warns of, as of most students' programs.
std::string warned(std::size_t student, std::mt19937& random) {
    const std::array<const char*, 4> bodies{
        "    int unused;\n    return x;\n",
        "    for (unsigned k = 0; k < n; ++k) x += 1;\n    return x;\n",
        "    float best, second;\n    if (x > 0) best = x;\n    return x;\n",
        "    if (n = 3) x += 1;\n    return x;\n",
    };
    return "float warned_" + std::to_string(student) + "(int n, float x)\n{\n" + bodies.at(random() % bodies.size()) +
           "}\n\n";
}

/// Before the program's last line, which closes main.
void add_before_the_end(std::string& body, const std::string& text) {
    const std::size_t at = body.rfind("return 0;");
    body.insert(at == std::string::npos ? body.rfind('}') : at, text);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv, argv + argc);
    if (words.size() != 6 || (words[1] != "starter" && words[1] != "wild" && words[1] != "typical")) {
        std::cerr << "make_class starter|wild|typical COUNT SEED SUBMISSIONS OUT\n";
        return 2;
    }
    // Pairs each program with a block that fits it, so that the compiler gives no message.
    const std::vector<std::pair<std::string, std::string>> bases{
        {"ada", "ada"}, {"farid", "farid"}, {"grace", "grace"}, {"hana", "hana"},
        {"jin", "ada"}, {"farid", "farid"}, {"ivan", "grace"},  {"wei", "hana"}};
    std::mt19937 random(static_cast<std::mt19937::result_type>(std::stoul(words[3])));
    const std::filesystem::path submissions = words[4], out = words[5];
    for (std::size_t student = 0; student < std::stoul(words[2]); ++student) {
        const auto& [base, starter] = bases[student % bases.size()];
        Program program = read(submissions / base / "ray_cast.cpp");
        const bool typical = words[1] == "typical";
        const auto one_of = [&](int per_cent) { return typical && random() % 100 < static_cast<unsigned>(per_cent); };
        const bool starts_alike = words[1] == "starter" || one_of(70);
        const std::string block =
            starts_alike ? block_of(read(submissions / starter / "ray_cast.cpp")) : own_block(program, student, random);
        const std::filesystem::path folder = out / ("student" + std::to_string(100000 + student).substr(1));
        std::filesystem::create_directories(folder);
        std::ofstream file(folder / "ray_cast.cpp");
        file << block << '\n' << own_helpers(student, random);
        if (one_of(60)) file << warned(student, random);
        if (one_of(5)) {
            add_before_the_end(program.body, "undeclared = 1;\n    ");
        } else if (one_of(3)) {
            add_before_the_end(program.body, "while (true) {}\n    ");
        }
        file << program.body;
        if (!file.flush()) throw std::runtime_error("can't write " + folder.string());
    }
}
