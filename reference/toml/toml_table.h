// Reads a TOML file strictly: every accessor either returns the requested value or throws an AssignmentError with file,
// line, key and the error. The only file that knows the TOML library is toml_table.cpp.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/numbers/decimal.h"

namespace reference {

class TomlDocument;

/// One table of the file, with its path in the file for messages. Valid as long as its TomlDocument.
class TomlTable {
  public:
    /// Rejects a key that is not in the list, so that a misspelled key is not silently ignored.
    void allow_only(const std::vector<std::string_view>& keys) const;

    bool has(std::string_view key) const;
    bool is_table(std::string_view key) const;
    std::vector<std::string> keys() const;

    TomlTable table(std::string_view key) const;
    /// The tables of [[key]], in the file's order; none when the key is absent.
    std::vector<TomlTable> tables(std::string_view key) const;
    std::string string(std::string_view key) const;
    /// A text, or the text of one of TOML's own dates with times.
    std::string moment_text(std::string_view key) const;
    std::vector<std::string> strings(std::string_view key) const;
    Decimal decimal(std::string_view key) const;
    std::vector<Decimal> decimals(std::string_view key, std::size_t count) const;
    std::vector<std::vector<Decimal>> decimal_rows(std::string_view key, std::size_t rows, std::size_t columns) const;
    /// Any number of rows.
    std::vector<std::vector<Decimal>> decimal_rows(std::string_view key, std::size_t columns) const;
    /// A whole number in [least, most].
    int integer(std::string_view key, int least, int most) const;
    /// A number in [least, most].
    double amount(std::string_view key, double least, double most) const;
    bool boolean(std::string_view key) const;

    template <class Enum>
    Enum choice(std::string_view key, const std::string& given,
                std::initializer_list<std::pair<std::string_view, Enum>> choices) const {
        std::string names;
        for (const auto& [name, value] : choices) {
            if (name == given) return value;
            names += (names.empty() ? "\"" : ", \"") + std::string(name) + "\"";
        }
        fail(key, "is \"" + given + "\", which is not one of " + names);
    }

    /// This key's position, for messages: "file:line: path.key".
    std::string place(std::string_view key) const;
    /// Throws an AssignmentError about this key, at its line when the key is there.
    [[noreturn]] void fail(std::string_view key, const std::string& what) const;

  private:
    friend class TomlDocument;
    struct Impl;
    explicit TomlTable(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
    std::shared_ptr<const Impl> impl_;
};

class TomlDocument {
  public:
    /// Parses TOML text; `path` names it in messages. Throws AssignmentError with line and column.
    TomlDocument(std::string_view text, const std::filesystem::path& path);
    ~TomlDocument();
    TomlDocument(const TomlDocument&) = delete;
    TomlDocument& operator=(const TomlDocument&) = delete;

    TomlTable root() const;

  private:
    friend class TomlTable;
    struct Impl;
    std::shared_ptr<const Impl> impl_;
};

}  // namespace reference
