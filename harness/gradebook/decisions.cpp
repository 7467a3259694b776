// The gradebook's decisions of a review.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "harness/gradebook/database.h"
#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/rows.h"

namespace harness {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Override, question, item, points, why, by, when)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Reread, question, item, lines, layout, why, by, when)

namespace {

using nlohmann::json;
using SQLite::Statement;

using Kind = Decision::Kind;

Kind kind_called(const std::string& name) {
    for (const Kind kind : {Kind::comment, Kind::points, Kind::reading}) {
        if (to_string(kind) == name) return kind;
    }
    return Kind::accepted;
}

std::optional<std::string> replaced_by(const Decision& decision) {
    if (decision.replaced_override) return json(*decision.replaced_override).dump();
    if (decision.replaced_reread) return json(*decision.replaced_reread).dump();
    return std::nullopt;
}

/// Throws json::exception if the text is not one that replaced_by wrote.
void read_replaced(const std::string& text, Decision& decision) {
    if (decision.kind == Kind::points) {
        decision.replaced_override = json::parse(text).get<Override>();
    } else {
        decision.replaced_reread = json::parse(text).get<Reread>();
    }
}

std::string name_of(const KeptDecision& kept) {
    const Decision& given = kept.given;
    const std::string about = given.about.empty() ? "" : " of " + given.about;
    return fmt::format("decision {}: {}{} of {}", given.number, to_string(given.kind), about, kept.submission);
}

/// The decision in the second to eighth columns of a row, without the values that it replaced.
Decision decision_in(Statement& row) {
    const auto text = [&](int column) { return row.getColumn(column).getString(); };
    return {row.getColumn(1).getInt64(),
            kind_called(text(2)),
            text(3),
            text(4),
            text(5),
            text(6),
            text(7),
            std::nullopt,
            std::nullopt};
}

/// Whether the audit trail does not have this yet. It has overrides and rereads already.
bool is_news(const Decision& decision) {
    return decision.kind == Kind::accepted || decision.kind == Kind::comment;
}

}  // namespace

std::vector<KeptDecision> Gradebook::decisions() const {
    if (!database_) return {};
    return in_database(file_, [&] {
        Statement query(*database_,
                        "SELECT submission, decision, kind, about, seen, text, who, at, before FROM decisions "
                        "WHERE undone_at IS NULL ORDER BY decision, rowid");
        std::vector<KeptDecision> all;
        while (query.executeStep()) {
            KeptDecision kept{new_id(query.getColumn(0).getString()), decision_in(query)};
            try {
                if (!query.getColumn(8).isNull()) read_replaced(query.getColumn(8).getString(), kept.given);
            } catch (const json::exception&) {
                throw HarnessError(gradebook_damage(file_, fmt::format("decision {}", kept.given.number)));
            }
            all.push_back(std::move(kept));
        }
        return all;
    });
}

std::vector<UndoneDecision> Gradebook::undone_decisions() const {
    if (!database_) return {};
    return in_database(file_, [&] {
        Statement query(*database_,
                        "SELECT submission, decision, kind, about, seen, text, who, at, undone_by, undone_at "
                        "FROM decisions WHERE undone_at IS NOT NULL ORDER BY decision, rowid");
        std::vector<UndoneDecision> all;
        while (query.executeStep()) {
            all.push_back({{new_id(query.getColumn(0).getString()), decision_in(query)},
                           {query.getColumn(8).getString(), query.getColumn(9).getString()}});
        }
        return all;
    });
}

std::int64_t Gradebook::next_decision() const {
    if (!database_) return 1;
    return in_database(file_, [&] {
        return database_->execAndGet("SELECT COALESCE(MAX(decision), 0) + 1 FROM decisions").getInt64();
    });
}

void Gradebook::put_decision(const KeptDecision& kept) {
    write([&] {
        const Decision& given = kept.given;
        execute(*database_,
                "INSERT INTO decisions (decision, submission, kind, about, seen, text, who, at, before) "
                "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
                given.number, kept.submission, to_string(given.kind), given.about, given.seen, given.text, given.by,
                given.when, replaced_by(given));
        if (is_news(given)) write_audit(*database_, {given.by, given.when}, name_of(kept), std::nullopt, given.text);
    });
}

void Gradebook::undo_decision(const KeptDecision& kept, const Author& author) {
    write([&] {
        const int undone = execute(
            *database_,
            "UPDATE decisions SET undone_at = ?, undone_by = ? WHERE decision = ? AND submission = ? AND "
            "kind = ? AND about = ? AND undone_at IS NULL",
            author.when, author.name, kept.given.number, kept.submission, to_string(kept.given.kind), kept.given.about);
        if (undone == 0) return;
        write_audit(*database_, author, name_of(kept), kept.given.text, "undone");
    });
}

std::string Gradebook::version() const {
    if (!database_) return "";
    // A new file starts its audit trail at 1 again, and a file system may reuse an inode.
    struct statx file {};
    statx(AT_FDCWD, file_.c_str(), 0, STATX_INO | STATX_BTIME, &file);
    return in_database(file_, [&] {
        return fmt::format("{}:{} {} {}.{} {}", file.stx_dev_major, file.stx_dev_minor, file.stx_ino,
                           file.stx_btime.tv_sec, file.stx_btime.tv_nsec,
                           database_->execAndGet("SELECT COALESCE(MAX(entry), 0) FROM audit").getInt64());
    });
}

void Gradebook::together(const std::function<void()>& changes) {
    write(changes);
}

void Gradebook::write(const std::function<void()>& change) {
    if (in_transaction_) return change();
    in_database(file_, [&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        in_transaction_ = true;
        try {
            change();
        } catch (...) {
            in_transaction_ = false;
            throw;
        }
        in_transaction_ = false;
        transaction.commit();
    });
}

}  // namespace harness
