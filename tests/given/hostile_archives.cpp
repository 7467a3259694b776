#include "tests/given/hostile_archives.h"

#include <algorithm>
#include <array>
#include <random>

#include "tests/given/forged_archives.h"

namespace {

using namespace forged;

using Random = std::mt19937;
using Size = std::size_t;

Size number(Random& random, Size least, Size most) {
    return least + random() % (most - least + 1);
}

HostileArchive as_zip(const std::string& what, std::string bytes) {
    return {"x.zip", std::move(bytes), what};
}

/// As a tar, or packed by gzip.
HostileArchive as_tar(Random& random, const std::string& what, const std::string& bytes) {
    switch (random() % 3) {
        case 0: return {"x.tar", bytes, what};
        case 1: return {"x.tgz", gzipped(bytes), what};
        default: return {"x.tar.gz", gzipped(bytes), what};
    }
}

const std::string source = "ray_cast.cpp";

std::string bad_name(Random& random) {
    const std::array<std::string, 14> names = {
        "../../" + source,
        "a/../../../" + source,
        "/tmp/raygrade-escaped.cpp",
        "C:\\windows\\" + source,
        "..\\..\\" + source,
        std::string("a\0b.cpp", 7),
        "new\nline.cpp",
        "\x1b[2J\x1b]0;x\x07.cpp",
        "\xff\xfe\xfd.cpp",
        "\xe2\x80\xae"
        "ppc.tsac.cpp",
        "a//.//./" + source,
        "//server/" + source,
        "x.cpp/" + source,
        std::string(300, '%') + "s%n.cpp",
    };
    return names[random() % names.size()];
}

using Attack = HostileArchive (*)(Random&);

HostileArchive deep_zip(Random& random) {
    return as_zip("a deep path", zip_of_names({repeated("a/", number(random, 16'000, 32'000)) + source}));
}

HostileArchive many_deep_zip(Random& random) {
    std::vector<std::string> names;
    for (Size i = 0; i < 5000; ++i) {
        std::string name;
        for (Size j = 0, deep = number(random, 20, 31); j < deep; ++j) name += std::to_string(random() % 100) + '/';
        names.push_back(name + source);
    }
    return as_zip("many paths as deep as is allowed", zip_of_names(names));
}

HostileArchive deep_pax(Random& random) {
    const std::string path = repeated("a/", number(random, 100'000, 400'000)) + source;
    return as_tar(random, "a deep path in a PAX header", tar({pax(pax_record("path", path)), {source}}));
}

HostileArchive long_gnu_name(Random& random) {
    const std::string path = repeated("abc/", number(random, 30'000, 250'000)) + source;
    return as_tar(random, "a long name of GNU tar", tar({{"././@LongLink", path, 'L'}, {source}}));
}

HostileArchive long_gnu_link(Random& random) {
    const std::string path(number(random, 100'000, 1'000'000), 'l');
    return as_tar(random, "a long link of GNU tar", tar({{"././@LongLink", path, 'K'}, {source, "", '2'}}));
}

HostileArchive nested_pax(Random& random) {
    std::vector<TarEntry> entries;
    for (Size i = 0, count = number(random, 500, 3000); i < count; ++i)
        entries.push_back(pax(pax_record("path", "a" + std::to_string(i)), random() % 2 == 0 ? 'x' : 'g'));
    entries.push_back({source});
    return as_tar(random, "PAX headers of PAX headers", tar(entries));
}

HostileArchive many_pax_records(Random& random) {
    std::string records;
    for (Size i = 0; i < 20'000; ++i) records += pax_record("SCHILY.xattr.user." + std::to_string(i), "v");
    return as_tar(random, "many PAX records", tar({pax(records), {source}}));
}

HostileArchive lying_pax(Random& random) {
    const std::array<std::string, 6> sizes = {"9223372036854775807", "-1", "99999999999999999999", "1e9", "", "0"};
    const std::string record = pax_record("size", sizes[random() % sizes.size()]);
    return as_tar(random, "a PAX size that lies", tar({pax(record + "99999 path=x\n"), {source}}));
}

HostileArchive sparse(Random& random) {
    const std::string size = std::to_string(std::uint64_t{1} << number(random, 20, 62));
    std::string map;
    for (Size i = 0, count = number(random, 1, 20'000); i < count; ++i)
        map += (i == 0 ? "" : ",") + std::to_string(i) + ",1";
    const std::string records = pax_record("GNU.sparse.major", "0") + pax_record("GNU.sparse.minor", "1") +
                                pax_record("GNU.sparse.name", source) + pax_record("GNU.sparse.size", size) +
                                pax_record("GNU.sparse.numblocks", "4000000000") + pax_record("GNU.sparse.map", map);
    return as_tar(random, "a sparse file", tar({pax(records), {source}}));
}

HostileArchive sparse_with_map(Random& random) {
    std::string map = std::to_string(number(random, 1, 4'000'000'000)) + '\n';
    for (Size i = 0; i < 1000; ++i) map += std::to_string(random()) + '\n';
    const std::string records = pax_record("GNU.sparse.major", "1") + pax_record("GNU.sparse.minor", "0") +
                                pax_record("GNU.sparse.realsize", "99999999999") +
                                pax_record("GNU.sparse.name", source);
    return as_tar(random, "a sparse file with its map within", tar({pax(records), {source, map}}));
}

HostileArchive same_names(Random& random) {
    std::vector<std::string> names(number(random, 10'000, 20'000), source);
    for (Size i = 2; i < 500; ++i) names.push_back(source + " (entry " + std::to_string(i) + ").cpp");
    return as_zip("one name many times", zip_of_names(names));
}

HostileArchive same_names_tar(Random& random) {
    return as_tar(random, "one name many times", tar(std::vector<TarEntry>(number(random, 5'000, 19'000), {source})));
}

HostileArchive too_many(Random& random) {
    std::vector<std::string> names;
    for (Size i = 0, count = number(random, 20'001, 65'000); i < count; ++i)
        names.push_back(std::to_string(i) + ".cpp");
    return as_zip("too many entries", zip_of_names(names));
}

HostileArchive long_names(Random& random) {
    std::vector<std::string> names;
    for (Size i = 0; i < 8000; ++i)
        names.push_back(std::string(number(random, 900, 980), 'n') + std::to_string(i) + ".cpp");
    return as_zip("many long names", zip_of_names(names));
}

HostileArchive lying_sizes(Random& random) {
    Member member{source};
    member.unpacked = static_cast<std::uint32_t>(random());
    member.packed_off_by = random() % 2 == 0 ? 0 : static_cast<std::uint32_t>(random());
    member.method = random() % 2 == 0 ? 0 : 8;
    return as_zip("sizes that lie", zip({member, {"b.cpp"}}));
}

HostileArchive two_names(Random& random) {
    Member member{source};
    member.other_name = bad_name(random);
    return as_zip("a member with two names", zip({{"a.cpp"}, member}));
}

HostileArchive bomb(Random& random) {
    const std::string zeros(Size{1} << number(random, 20, 26), random() % 2 == 0 ? '\0' : 'a');
    const Member member{source, deflated(zeros), static_cast<std::uint32_t>(zeros.size()), crc32(zeros), 8};
    return as_zip("a bomb", zip({member}));
}

HostileArchive overlapping_bomb(Random& random) {
    const std::string zeros(Size{1} << 20U, ' ');
    std::vector<Member> members(number(random, 500, 5000),
                                {source, deflated(zeros), static_cast<std::uint32_t>(zeros.size()), crc32(zeros), 8});
    for (Size i = 1; i < members.size(); ++i) {
        members[i].offset_of = 0;
        members[i].other_name = std::to_string(i) + ".cpp";
    }
    return as_zip("a bomb of members that share their bytes", zip(members));
}

HostileArchive gzip_bomb(Random& random) {
    const std::string zeros(Size{1} << 24U, '\0');
    const std::string size("\x80\0\0\0\0\0\0\x7f\xff\xff\xff\xff", 12);
    const bool is_source = random() % 2 == 0;
    const std::string head = gzipped(tar_entry({is_source ? source : "big.bin", "", '0', {}, size}));
    return {"x.tar.gz", head + repeated(gzipped(zeros), number(random, 20, 200)), "a bomb of gzip"};
}

HostileArchive gzip_of_gzip(Random& random) {
    std::string bytes = tar({{source}});
    for (Size i = 0, times = number(random, 2, 200); i < times; ++i) bytes = gzipped(bytes);
    return {"x.tar.gz", bytes, "gzip of gzip of gzip"};
}

HostileArchive nested(Random& random) {
    std::string inner = zip_of_names({source});
    for (Size i = 0, times = number(random, 1, 50); i < times; ++i) {
        const Member member{"x.zip", inner, static_cast<std::uint32_t>(inner.size()), crc32(inner)};
        inner = zip({member, {std::to_string(i) + ".txt"}});
    }
    return as_zip("archives in archives", inner);
}

HostileArchive odd_method(Random& random) {
    constexpr std::array<std::uint16_t, 10> methods = {1, 6, 9, 12, 14, 20, 93, 95, 98, 99};
    Member member{source, std::string("\x09\x14\x05\0\x5d\xff\xff\xff\xff", 9) + std::string(500, '\x55')};
    member.method = methods[random() % methods.size()];
    member.unpacked = 4'000'000;
    return as_zip("a method of packing that takes memory", zip({member}));
}

HostileArchive odd_extra(Random& random) {
    Member member{source};
    const std::array<std::uint16_t, 5> ids = {0x0001, 0x7075, 0x5455, 0x9901, 0x7875};
    for (Size i = 0; i < number(random, 1, 50); ++i)
        member.extra += little_endian(ids[random() % ids.size()], 2) + little_endian(random() % 40, 2) +
                        little_endian(0xFFFFFFFFFFFFFFFF, 8) + little_endian(random(), 8);
    if (random() % 2 == 0) member.unpacked = 0xFFFFFFFF;
    return as_zip("odd extra fields", zip({member}));
}

HostileArchive zip_links(Random& random) {
    constexpr std::array<std::uint32_t, 6> types = {0120777, 0020666, 0060666, 0010666, 0140777, 0170000};
    Member member{source, "/etc/passwd", 11, crc32("/etc/passwd")};
    member.attributes = types[random() % types.size()] << 16U;
    return as_zip("a link or a device", zip({member, {"b.cpp"}}));
}

HostileArchive encrypted(Random&) {
    Member member{source};
    member.flags = 1;
    return as_zip("a password", zip({member}));
}

HostileArchive tar_links(Random& random) {
    constexpr std::array<char, 9> types = {'1', '2', '3', '4', '5', '6', '7', 'D', 'S'};
    const TarEntry link{source, random() % 2 == 0 ? "" : honest_source, types[random() % types.size()], "/etc/passwd"};
    return as_tar(random, "a link, a device, a pipe", tar({link, {source}}));
}

HostileArchive tar_sizes(Random& random) {
    const std::array<std::string, 4> sizes = {std::string("\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff", 12),
                                              std::string("\x80\0\0\0\x7f\xff\xff\xff\xff\xff\xff\xff", 12),
                                              "77777777777 ", "-0000000001 "};
    return as_tar(random, "a size that lies",
                  tar({{source, honest_source, '0', {}, sizes[random() % sizes.size()]}, {"b.cpp"}}));
}

HostileArchive bad_names(Random& random) {
    return as_zip("a name that leads elsewhere", zip_of_names({"a.cpp", bad_name(random), "b.cpp"}));
}

HostileArchive bad_names_tar(Random& random) {
    const std::string name = bad_name(random);
    if (random() % 2 == 0) return as_tar(random, "a name that leads elsewhere", tar({{name}, {source}}));
    return as_tar(random, "a PAX name that leads elsewhere", tar({pax(pax_record("path", name)), {source}}));
}

HostileArchive colliding_names(Random&) {
    return as_zip("names that differ by case",
                  zip_of_names({source, "RAY_CAST.CPP", "Ray_Cast.cpp", "ray_cast.cpp/x.cpp", "ray_cast.cpp.cpp"}));
}

HostileArchive file_and_folder(Random& random) {
    std::vector<std::string> names;
    std::string name = "a.cpp";
    for (Size i = 0; i < 31; ++i, name += "/a.cpp") names.push_back(name);
    std::shuffle(names.begin(), names.end(), random);
    return as_zip("files that are folders", zip_of_names(names));
}

HostileArchive garbage(Random& random) {
    const std::array<std::string, 6> heads = {"PK\x03\x04",   "PK\x05\x06", "\x1f\x8b\x08",
                                              "Rar!\x1a\x07", "7z\xbc\xaf", ""};
    std::string bytes = heads[random() % heads.size()];
    for (Size i = 0, count = number(random, 0, 4000); i < count; ++i) bytes += static_cast<char>(random());
    const std::array<std::string, 4> names = {"x.zip", "x.tar", "x.tar.gz", "x.tgz"};
    return {names[random() % names.size()], bytes, "no archive at all"};
}

constexpr std::array<Attack, 33> attacks = {
    deep_zip,         many_deep_zip, deep_pax,    long_gnu_name,   long_gnu_link, nested_pax,
    many_pax_records, lying_pax,     sparse,      sparse_with_map, same_names,    same_names_tar,
    too_many,         long_names,    lying_sizes, two_names,       bomb,          overlapping_bomb,
    gzip_bomb,        gzip_of_gzip,  nested,      odd_method,      odd_extra,     zip_links,
    encrypted,        tar_links,     tar_sizes,   bad_names,       bad_names_tar, colliding_names,
    file_and_folder,  garbage,       garbage,
};

void damage(std::string& bytes, Random& random) {
    if (bytes.empty()) return;
    const Size at = random() % bytes.size();
    switch (random() % 4) {
        case 0:
            for (Size i = 0, count = number(random, 1, 20); i < count; ++i)
                bytes[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
            return;
        case 1: bytes.resize(at); return;
        case 2: bytes += bytes.substr(at); return;
        default: bytes.erase(at, number(random, 1, 600)); return;
    }
}

}  // namespace

std::uint32_t hostile_archive_kinds() {
    return static_cast<std::uint32_t>(attacks.size());
}

HostileArchive hostile_archive(std::uint32_t seed) {
    Random random(seed);
    HostileArchive made = attacks[seed % attacks.size()](random);
    const std::uint32_t round = seed / hostile_archive_kinds();
    if (round % 2 == 1) {
        damage(made.bytes, random);
        made.what += ", damaged";
    }
    return made;
}
