#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace engine {

/// An SQLite call that failed, in this program's words ("no space is left on the device").
class DatabaseError : public std::runtime_error {
  public:
    explicit DatabaseError(int sqlite_code);
    /// The content is not what the caller expects: a missing column, another type.
    explicit DatabaseError(const std::string& what) : std::runtime_error(what) {}
};

/// A prepared statement. Columns and parameters are numbered from 0. Throws DatabaseError.
class Statement {
  public:
    Statement(sqlite3& database, const std::string& sql);

    Statement& bind(int parameter, std::int64_t value);
    Statement& bind(int parameter, std::string_view text);
    /// Bit-exact, the sign of zero included: a whole number is bound as an integer, which SQLite stores in 0 to 8
    /// bytes, anything else as REAL. Wants a column without a declared type, so that SQLite converts nothing.
    Statement& bind_exact(int parameter, double value);
    Statement& bind_bytes(int parameter, std::string_view bytes);

    /// True while there is a row.
    bool step();
    /// Ready to run anew; bound values stay.
    void reset();
    /// Runs a statement that returns no rows, and makes it ready for the next values.
    void run();

    std::int64_t integer(int column) const;
    double exact(int column) const; ///< what bind_exact stored
    std::string text(int column) const;
    std::string bytes(int column) const; ///< of a BLOB
    int column_count() const;

  private:
    void expect(int column, bool right_type) const;
    std::string content_of(int column) const;

    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// One connection to an SQLite file; used by one thread at a time. Throws DatabaseError.
class Database {
  public:
    /// For writing; creates the file if it is not there.
    static Database create(const std::filesystem::path& file);
    /// For reading; leaves the file and its write-ahead log as they are. A finished file may lie in a folder that
    /// cannot be written.
    static Database open(const std::filesystem::path& file);

    Statement prepare(const std::string& sql) { return {*connection_, sql}; }
    void execute(const std::string& sql) { prepare(sql).run(); }
    /// The one integer that `sql` yields.
    std::int64_t integer(const std::string& sql);
    /// Undoes what the present transaction did, if there is one. Never throws.
    void roll_back() noexcept;
    /// The file is no longer where it was when it was opened: removed or renamed.
    bool has_moved() const;

  private:
    Database(const std::string& uri, int flags);

    struct Close {
        void operator()(sqlite3* connection) const;
    };
    std::unique_ptr<sqlite3, Close> connection_;
};

} // namespace engine
