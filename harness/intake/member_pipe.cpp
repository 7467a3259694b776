#include "harness/intake/member_pipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "harness/machine/errors.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

enum class Frame : std::uint32_t { file = 1, too_large_file, refused_folder, refused_file, refusal, end };

/// The header before the bytes. The same program is at both ends, so the header is sent as it is in memory.
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
    return "cannot be read: the process that reads it crashed";
}

[[noreturn]] void refuse(const std::string& shown, const std::string& why) {
    throw ArchiveError(fmt::format("{} {}. Pack it again.", shown, why));
}

/// Whether archive_entries.cpp can send such a path.
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

class MemberReceiver {
  public:
    MemberReceiver(ConfinedChild& child, const std::string& shown, const Wanted& wanted, const ArchiveLimits& limits)
        : child_(child), shown_(shown), wanted_(wanted), limits_(limits) {}

    std::vector<ArchiveFile> receive() {
        for (;;) {
            Head head{};
            read(&head, sizeof head);
            switch (head.kind) {
                case Frame::file:
                case Frame::too_large_file: receive_file(head); continue;
                case Frame::refused_folder:
                case Frame::refused_file: receive_refused_student(head); continue;
                case Frame::refusal: {
                    if (head.path_bytes > longest_refusal) distrust();
                    throw ArchiveError(printable(text(head.path_bytes)));
                }
                case Frame::end: return std::move(files_);
            }
            distrust();
        }
    }

  private:
    std::string receive_path(const Head& head) {
        if (head.path_bytes > limits_.path_bytes) distrust();
        std::string path = text(head.path_bytes);
        if (!is_sent(path, limits_)) distrust();
        return path;
    }

    void receive_file(const Head& head) {
        ArchiveFile file{receive_path(head), {}, head.kind == Frame::too_large_file};
        if (head.bytes > (file.too_large ? 0 : wanted_(file.path))) distrust();
        if (head.bytes > limits_.kept_bytes - kept_) distrust();
        kept_ += head.bytes;
        file.bytes = text(static_cast<std::size_t>(head.bytes));
        keep(std::move(file));
    }

    void receive_refused_student(const Head& head) {
        if (head.bytes > longest_refusal) distrust();
        ArchiveFile refused{receive_path(head), {}, false};
        refused.refusal = printable(text(static_cast<std::size_t>(head.bytes)));
        refused.is_folder = head.kind == Frame::refused_folder;
        keep(std::move(refused));
    }

    /// The child has counted a refused entry but not sent it.
    void keep(ArchiveFile file) {
        path_bytes_ += file.path.size() + file.refusal.size();
        if (files_.size() == limits_.entries || path_bytes_ > limits_.all_path_bytes) distrust();
        files_.push_back(std::move(file));
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
                               " cannot be read: not enough memory. Free some memory, or raise the limit `ulimit -v`.");
        }
        refuse(shown_, why_ended(how, limits_.reading));
    }

    [[noreturn]] void distrust() const { refuse(shown_, why_ended(ChildEnd::crashed, limits_.reading)); }

    ConfinedChild& child_;
    const std::string& shown_;
    const Wanted& wanted_;
    const ArchiveLimits& limits_;
    std::vector<ArchiveFile> files_;
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
    const Head head{student.is_folder ? Frame::refused_folder : Frame::refused_file,
                    static_cast<std::uint32_t>(student.place.size()), sentence.size()};
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
                                         const ArchiveLimits& limits) {
    return MemberReceiver(child, shown, wanted, limits).receive();
}

}  // namespace harness
