#include "harness/intake/member_pipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "harness/machine/errors.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

enum class Frame : std::uint32_t { file = 1, too_large_file, refused_student, refusal, end };

/// What comes before the bytes. Both ends are the same program, so it goes over the pipe as it lies in memory.
struct Head {
    Frame kind;
    std::uint32_t path_bytes;  ///< for a refusal the length of the sentence
    std::uint64_t bytes;       ///< for a refused student the length of the sentence
};

constexpr std::size_t longest_refusal = 4096;

std::string why_ended(ChildEnd how, const ChildLimits& limits) {
    switch (how) {
        case ChildEnd::cpu_limit:
            return fmt::format("takes more than {} s of processor time to read", limits.cpu.count());
        case ChildEnd::wall_limit: return fmt::format("takes longer than {} s to read", limits.wall.count());
        case ChildEnd::memory_limit:
            return fmt::format("takes more than {} MiB of memory to read", limits.memory_bytes >> 20U);
        case ChildEnd::done:
        case ChildEnd::machine_memory:
        case ChildEnd::crashed: break;
    }
    return "can't be read: the process that reads it broke down";
}

[[noreturn]] void refuse(const std::string& shown, const std::string& why) {
    throw ArchiveError(fmt::format("{} {}. Ask whoever packed it to pack it anew.", shown, why));
}

/// Whether archive_entries.cpp sends such a path.
bool is_sent(std::string_view path, const ArchiveLimits& limits) {
    if (path.find('\0') != std::string_view::npos) return false;
    std::size_t names = 0;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string_view name = path.substr(begin, end - begin);
        if (name.empty() || name.front() == '.' || ++names > limits.path_names) return false;
        begin = end + 1;
    }
    return true;
}

/// What one student, or nobody, has sent.
struct Sent {
    std::vector<std::size_t> files;
    std::size_t path_bytes = 0;
    std::uint64_t kept = 0;
    bool is_refused = false;
};

class MemberReceiver {
  public:
    MemberReceiver(ConfinedChild& child, const std::string& shown, const Wanted& wanted, const ArchiveLimits& limits,
                   Shares shares)
        : child_(child), shown_(shown), wanted_(wanted), limits_(limits), shares_(shares) {}

    std::vector<ArchiveFile> receive() {
        for (;;) {
            Head head{};
            read(&head, sizeof head);
            switch (head.kind) {
                case Frame::file:
                case Frame::too_large_file: receive_file(head); continue;
                case Frame::refused_student: receive_refused_student(head); continue;
                case Frame::refusal: {
                    if (head.path_bytes > longest_refusal) distrust();
                    throw ArchiveError(printable(text(head.path_bytes)));
                }
                case Frame::end:
                    std::erase_if(files_, [](const ArchiveFile& file) { return file.path.empty(); });
                    return std::move(files_);
            }
            distrust();
        }
    }

  private:
    EntryOwner owner_of(std::string_view path) const {
        return shares_ == Shares::none ? EntryOwner() : owner_of_entry(path);
    }

    std::string receive_path(const Head& head) {
        if (head.path_bytes > limits_.path_bytes) distrust();
        std::string path = text(head.path_bytes);
        if (!is_sent(path, limits_)) distrust();
        return path;
    }

    void receive_file(const Head& head) {
        ArchiveFile file{receive_path(head), {}, head.kind == Frame::too_large_file};
        const EntryOwner owner = owner_of(file.path);
        Sent& sent = sent_[owner.key];
        const ArchiveLimits& limits = owner.key.empty() ? limits_ : limits_of_a_share;
        if (sent.is_refused || sent.files.size() == limits.entries) distrust();
        if (head.bytes > (file.too_large ? 0 : wanted_(file.path))) distrust();
        sent.path_bytes += file.path.size();
        if (sent.path_bytes > limits.all_path_bytes || head.bytes > limits.kept_bytes - sent.kept) distrust();
        sent.kept += head.bytes;
        path_bytes_ += file.path.size();
        kept_ += head.bytes;
        if (shares_ == Shares::of_students) expect_less_than(limits_of_shares(students_without_limit));
        file.bytes = text(static_cast<std::size_t>(head.bytes));
        sent.files.push_back(files_.size());
        files_.push_back(std::move(file));
    }

    void receive_refused_student(const Head& head) {
        if (head.bytes > longest_refusal) distrust();
        ArchiveFile refused{receive_path(head), {}, false};
        refused.refusal = printable(text(static_cast<std::size_t>(head.bytes)));
        EntryOwner owner = owner_of(refused.path);
        if (owner.key.empty()) owner = owner_of(refused.path + '/');
        if (owner.key.empty()) distrust();
        Sent& sent = sent_[owner.key];
        if (sent.is_refused) distrust();
        path_bytes_ -= sent.path_bytes;
        kept_ -= sent.kept;
        for (const std::size_t at : sent.files) files_[at] = {};
        while (!files_.empty() && files_.back().path.empty()) files_.pop_back();
        sent = {};
        sent.is_refused = true;
        refused.is_folder = owner.is_folder;
        path_bytes_ += refused.path.size() + refused.refusal.size();
        files_.push_back(std::move(refused));
        expect_less_than(limits_of_shares(students_without_limit));
    }

    void expect_less_than(const ArchiveLimits& whole) const {
        if (files_.size() >= 2 * whole.entries || path_bytes_ > 2 * whole.all_path_bytes) distrust();
        if (kept_ > whole.kept_bytes + limits_.kept_bytes) distrust();
    }

    std::string text(std::size_t size) {
        std::string bytes(size, '\0');
        read(bytes.data(), size);
        return bytes;
    }

    void read(void* bytes, std::size_t size) {
        if (child_.read(bytes, size)) return;
        const ChildEnd how = child_.end();
        if (how == ChildEnd::machine_memory) {
            throw HarnessError(shown_ +
                               " could not be read: too little memory is left for it. See to this machine's memory and "
                               "to the limit `ulimit -v`.");
        }
        refuse(shown_, why_ended(how, limits_.reading));
    }

    [[noreturn]] void distrust() const { refuse(shown_, why_ended(ChildEnd::crashed, limits_.reading)); }

    ConfinedChild& child_;
    const std::string& shown_;
    const Wanted& wanted_;
    const ArchiveLimits& limits_;
    const Shares shares_;
    /// The child also counts entries that it does not send, so it may know of more students.
    static constexpr std::size_t students_without_limit = 1'000'000;
    std::vector<ArchiveFile> files_;              ///< with empty ones in place of what a student has lost again
    std::unordered_map<std::string, Sent> sent_;  ///< by owner
    std::size_t path_bytes_ = 0;
    std::uint64_t kept_ = 0;
};

}  // namespace

void MemberSender::send(const ArchiveFile& file) {
    const Head head{file.too_large ? Frame::too_large_file : Frame::file, static_cast<std::uint32_t>(file.path.size()),
                    file.bytes.size()};
    write_all(pipe_, &head, sizeof head);
    write_all(pipe_, file.path.data(), file.path.size());
    write_all(pipe_, file.bytes.data(), file.bytes.size());
}

void MemberSender::refuse(const EntryOwner& student, std::string_view why) {
    const std::string_view sentence = why.substr(0, longest_refusal);
    const Head head{Frame::refused_student, static_cast<std::uint32_t>(student.place.size()), sentence.size()};
    write_all(pipe_, &head, sizeof head);
    write_all(pipe_, student.place.data(), student.place.size());
    write_all(pipe_, sentence.data(), sentence.size());
}

void MemberSender::refuse(std::string_view why) {
    const std::string_view sentence = why.substr(0, longest_refusal);
    const Head head{Frame::refusal, static_cast<std::uint32_t>(sentence.size()), 0};
    write_all(pipe_, &head, sizeof head);
    write_all(pipe_, sentence.data(), sentence.size());
}

void MemberSender::finish() {
    const Head head{Frame::end, 0, 0};
    write_all(pipe_, &head, sizeof head);
}

std::vector<ArchiveFile> receive_members(ConfinedChild& child, const std::string& shown, const Wanted& wanted,
                                         const ArchiveLimits& limits, Shares shares) {
    return MemberReceiver(child, shown, wanted, limits, shares).receive();
}

}  // namespace harness
