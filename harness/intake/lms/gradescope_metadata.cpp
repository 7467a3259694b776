#include "harness/intake/lms/gradescope_metadata.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <streambuf>
#include <utility>

#include "harness/text/printable.h"

namespace harness {
namespace {

constexpr std::size_t most_submissions = 20'000;  // ArchiveLimits::entries
constexpr std::size_t most_submitters = 50;
constexpr std::size_t most_anchors = 100'000;
constexpr std::size_t longest_text = 200;  // bytes of a name; of a longer text only the beginning is kept

/// The parser reads on to the end of a bracket before it reports the bracket's beginning, and keeps some 230 bytes for
/// each bracket it sees. So reading ends if the parser has read this many bytes without reporting anything. A text in a
/// Gradescope file has at most 100,000 characters.
constexpr std::size_t most_read_ahead = std::size_t{1} << 20U;

/// Gives the parser the file, and ends it early if the parser reads too far ahead.
class Bytes final : public std::streambuf {
  public:
    explicit Bytes(std::string_view bytes) : rest_(bytes) {}

    void told_of_something() { since_told_ = 0; }
    bool has_ended_early() const { return has_ended_early_; }

  private:
    int_type underflow() override {
        constexpr std::size_t step = 2048;
        const std::size_t count = std::min(step, rest_.size());
        has_ended_early_ = has_ended_early_ || since_told_ > most_read_ahead;
        if (count == 0 || has_ended_early_) return traits_type::eof();
        std::copy_n(rest_.begin(), count, buffer_);
        rest_.remove_prefix(count);
        since_told_ += count;
        setg(buffer_, buffer_, buffer_ + count);
        return traits_type::to_int_type(*gptr());
    }

    std::string_view rest_;
    char buffer_[2048];
    std::size_t since_told_ = 0;
    bool has_ended_early_ = false;
};

/// Thrown to end the reading: the whole file is unusable.
struct Unusable {
    std::string why;
};

std::string without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
}

/// Receives the parser's events and keeps track of the place in the file.
class MetadataReader final : public YAML::EventHandler {
  public:
    explicit MetadataReader(Bytes& bytes) : bytes_(bytes) {}

    GradescopeMetadata result;

    void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t anchor) override { take_text("", anchor); }

    void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t anchor,
                  const std::string& value) override {
        // One byte more than allowed, so that too long a text is noticed.
        take_text(value.substr(0, longest_text + 1), anchor);
    }

    void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t anchor) override {
        const auto text = texts_.find(anchor);
        if (text != texts_.end()) return take_text(text->second, 0);
        if (!places_.empty() && !is_key() && (places_.size() == in_file || is_about_submitters()))
            blame("has an alias where a name is expected");
        end_node();
    }

    void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value /*style*/) override {
        begin(Kind::sequence, anchor);
    }
    void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value /*style*/) override {
        begin(Kind::mapping, anchor);
    }
    void OnSequenceEnd() override { end(); }
    void OnMapEnd() override { end(); }

  private:
    enum class Kind { mapping, sequence };
    struct Place {
        Kind kind;
        bool awaits_key = true;  ///< in a mapping: the next node is a key
        std::string key{};       ///< in a mapping: the key of the current value
    };

    // The size of places_ inside each level of {folder: {submitters: [{name: text}]}}.
    static constexpr std::size_t in_file = 1, in_submission = 2, in_submitters = 3, in_submitter = 4;

    bool is_key() const {
        return !places_.empty() && places_.back().kind == Kind::mapping && places_.back().awaits_key;
    }

    /// Whether a node that is no key lies in a list of submitters.
    bool is_about_submitters() const {
        return places_.size() >= in_submission && places_[1].kind == Kind::mapping && places_[1].key == "submitters";
    }

    const std::string& folder() const { return places_.front().key; }

    void blame(const std::string& what) { result.problems.try_emplace(folder(), what); }

    void count_anchor(YAML::anchor_t anchor) {
        if (anchor != 0 && ++anchors_ > most_anchors) throw Unusable{"names more than 100,000 of its parts (&name)"};
    }

    /// In a mapping, keys and values alternate.
    void end_node() {
        bytes_.told_of_something();
        if (places_.empty() || places_.back().kind == Kind::sequence) return;
        places_.back().awaits_key = !places_.back().awaits_key;
    }

    void take_text(const std::string& text, YAML::anchor_t anchor) {
        count_anchor(anchor);
        if (anchor != 0) texts_[anchor] = text;
        if (places_.empty()) {
            if (!text.empty()) throw Unusable{"holds no submissions"};
        } else if (is_key()) {
            take_key(text);
        } else if (places_.size() == in_file) {
            blame("says nothing of it but a text");
        } else if (is_about_submitters()) {
            take_part(text);
        }
        end_node();
    }

    void take_key(const std::string& text) {
        std::string& key = places_.back().key;
        key = text.starts_with(':') ? text.substr(1) : text;
        if (places_.size() == in_file) {
            if (result.submitters.size() >= most_submissions) throw Unusable{"is of more than 20,000 submissions"};
            if (!result.submitters.try_emplace(key).second) blame("tells of it twice");
            has_submitters_ = false;
        } else if (places_.size() == in_submission && key == "submitters") {
            if (std::exchange(has_submitters_, true)) blame("says twice who handed it in");
        }
    }

    /// Where to store the current part of a submitter; null for a part that is not needed.
    std::string* part() {
        const std::string& key = places_.back().key;
        if (places_.size() != in_submitter || (key != "name" && key != "sid" && key != "email")) return nullptr;
        auto& submitters = result.submitters[folder()];
        if (submitters.empty()) return nullptr;
        Submitter& last = submitters.back();
        return key == "name" ? &last.name : key == "sid" ? &last.sid : &last.email;
    }

    /// Handles a text below submitters.
    void take_part(const std::string& text) {
        if (places_.size() <= in_submitters) blame("has a text where its submitters are expected");
        std::string* const to = part();
        if (to == nullptr) return;
        if (!to->empty()) blame("says twice what a submitter is called");
        if (text.size() > longest_text) blame("has a name of more than 200 bytes");
        if (printable(text) != text) blame("has a name that is no text");
        *to = without_blanks(text);
    }

    void begin(Kind kind, YAML::anchor_t anchor) {
        bytes_.told_of_something();
        count_anchor(anchor);
        if (places_.empty()) {
            if (kind != Kind::mapping) throw Unusable{"holds no submissions"};
        } else if (is_key()) {
            places_.back().key.clear();  // no needed key is a mapping or a list
        } else if (places_.size() == in_file) {
            if (kind != Kind::mapping) blame("says nothing of it but a list");
        } else if (is_about_submitters()) {
            begin_about_submitters(kind);
        }
        places_.push_back({kind});
    }

    void begin_about_submitters(Kind kind) {
        if (places_.size() == in_submission && kind != Kind::sequence) blame("has no list of its submitters");
        if (places_.size() == in_submitters) {
            auto& submitters = result.submitters[folder()];
            if (kind != Kind::mapping) blame("has a list where a submitter is expected");
            if (submitters.size() == most_submitters) blame("names more than 50 who handed it in");
            if (submitters.size() < most_submitters) submitters.emplace_back();
        }
        if (part() != nullptr) blame("has something else where a name is expected");
    }

    void end() {
        places_.pop_back();
        end_node();
    }

    Bytes& bytes_;
    std::vector<Place> places_;  ///< the outermost first
    std::map<YAML::anchor_t, std::string> texts_;
    std::size_t anchors_ = 0;
    bool has_submitters_ = false;  ///< the current submission has the key submitters
};

/// Removes the submitters of every folder that has a problem.
void settle(GradescopeMetadata& metadata) {
    for (const auto& [folder, submitters] : metadata.submitters) {
        const bool named = std::all_of(submitters.begin(), submitters.end(),
                                       [](const Submitter& submitter) { return !submitter.name.empty(); });
        if (submitters.empty() || !named) metadata.problems.try_emplace(folder, "does not say who handed it in");
    }
    for (const auto& [folder, problem] : metadata.problems) metadata.submitters.erase(folder);
}

}  // namespace

GradescopeMetadata read_gradescope_metadata(std::string_view yaml) {
    Bytes bytes(yaml);
    std::istream stream(&bytes);
    MetadataReader reading(bytes);
    std::string why;
    try {
        YAML::Parser parser(stream);
        if (!parser.HandleNextDocument(reading)) why = "is empty";
    } catch (const Unusable& unusable) {
        why = unusable.why;
    } catch (const YAML::Exception& error) {
        why = fmt::format("is no YAML from line {} on", error.mark.line + 1);
    }
    if (bytes.has_ended_early()) why = "has brackets or a text of more than 1 MiB";
    if (!why.empty()) return {{}, {}, why};
    settle(reading.result);
    return std::move(reading.result);
}

std::string names_of(const std::vector<Submitter>& submitters) {
    std::string names;
    for (const Submitter& submitter : submitters) names += (names.empty() ? "" : ", ") + submitter.name;
    return names;
}

}  // namespace harness
