#include "engine/database.h"

#include <cmath>
#include <sqlite3.h>

namespace engine {
namespace {

std::string in_plain_words(int sqlite_code) {
    switch (sqlite_code & 0xff) {
    case SQLITE_FULL:
        return "no space is left on the device";
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return "the file or its folder cannot be opened or written";
    case SQLITE_IOERR:
        return "the device refuses to read or write";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_SCHEMA:
        return "the database is damaged";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return "another program holds the file";
    case SQLITE_NOMEM:
    case SQLITE_TOOBIG:
        return "more memory is needed than there is";
    default:
        return "the database failed (SQLite code " + std::to_string(sqlite_code) + ")";
    }
}

void check(int sqlite_code) {
    if (sqlite_code != SQLITE_OK) {
        throw DatabaseError(sqlite_code);
    }
}

/// A path as SQLite's file: URI, which lets the caller add parameters.
std::string uri_of(const std::filesystem::path& file) {
    std::string uri = "file:";
    for (const char c : std::filesystem::absolute(file).string()) {
        if (c == '?' || c == '#' || c == '%') {
            constexpr std::string_view digits = "0123456789abcdef";
            const auto byte = static_cast<unsigned char>(c);
            uri += {'%', digits[byte >> 4u], digits[byte & 15u]};
        } else {
            uri += c;
        }
    }
    return uri;
}

} // namespace

DatabaseError::DatabaseError(int sqlite_code) : std::runtime_error(in_plain_words(sqlite_code)) {}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(sqlite3& database, const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(&database, sql.c_str(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    if (code == SQLITE_ERROR) { // a table or column that the SQL names is not there
        throw DatabaseError("the database lacks what a recording has");
    }
    check(code);
}

Statement& Statement::bind(int parameter, std::int64_t value) {
    check(sqlite3_bind_int64(statement_.get(), parameter + 1, value));
    return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
    check(sqlite3_bind_text(statement_.get(), parameter + 1, text.data(), static_cast<int>(text.size()),
                            SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind_exact(int parameter, double value) {
    constexpr double exactly_whole_below = 9007199254740992.0; // 2^53
    const bool whole = std::fabs(value) < exactly_whole_below && value == std::trunc(value);
    if (whole && !(value == 0.0 && std::signbit(value))) {
        return bind(parameter, static_cast<std::int64_t>(value));
    }
    if (std::isnan(value)) { // SQLite would store NULL
        throw DatabaseError("a value is not a number");
    }
    check(sqlite3_bind_double(statement_.get(), parameter + 1, value));
    return *this;
}

Statement& Statement::bind_bytes(int parameter, std::string_view bytes) {
    check(sqlite3_bind_blob(statement_.get(), parameter + 1, bytes.data(), static_cast<int>(bytes.size()),
                            SQLITE_TRANSIENT));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) {
        return true;
    }
    if (code != SQLITE_DONE) {
        sqlite3_reset(statement_.get());
        throw DatabaseError(code);
    }
    return false;
}

void Statement::reset() {
    sqlite3_reset(statement_.get()); // repeats the last step's error, which step() has told
}

void Statement::run() {
    while (step()) {
    }
    reset();
}

void Statement::expect(int column, bool right_type) const {
    if (!right_type) {
        throw DatabaseError(std::string("column ") + sqlite3_column_name(statement_.get(), column) +
                            " holds another type than it should");
    }
}

std::int64_t Statement::integer(int column) const {
    expect(column, sqlite3_column_type(statement_.get(), column) == SQLITE_INTEGER);
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::exact(int column) const {
    const int type = sqlite3_column_type(statement_.get(), column);
    expect(column, type == SQLITE_FLOAT || type == SQLITE_INTEGER);
    return sqlite3_column_double(statement_.get(), column);
}

std::string Statement::text(int column) const {
    expect(column, sqlite3_column_type(statement_.get(), column) == SQLITE_TEXT);
    return content_of(column);
}

std::string Statement::bytes(int column) const {
    expect(column, sqlite3_column_type(statement_.get(), column) == SQLITE_BLOB);
    return content_of(column);
}

std::string Statement::content_of(int column) const {
    const auto* content = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return size == 0 ? std::string() : std::string(content, size);
}

int Statement::column_count() const {
    return sqlite3_column_count(statement_.get());
}

void Database::Close::operator()(sqlite3* connection) const {
    sqlite3_close_v2(connection);
}

Database::Database(const std::string& uri, int flags) {
    sqlite3* connection = nullptr;
    const int code = sqlite3_open_v2(uri.c_str(), &connection, flags | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
    connection_.reset(connection);
    check(code);
    constexpr int patience_milliseconds = 100;
    check(sqlite3_busy_timeout(connection_.get(), patience_milliseconds));
}

Database Database::create(const std::filesystem::path& file) {
    return {uri_of(file), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE};
}

Database Database::open(const std::filesystem::path& file) {
    // Without a log nothing is unfinished, and `immutable` then asks for no lock and leaves no helper files behind.
    std::error_code none;
    const auto log_size = std::filesystem::file_size(file.string() + "-wal", none);
    const bool finished = none || log_size == 0;
    return {uri_of(file) + (finished ? "?immutable=1" : ""), SQLITE_OPEN_READONLY};
}

std::int64_t Database::integer(const std::string& sql) {
    Statement statement = prepare(sql);
    if (!statement.step()) {
        throw DatabaseError("the database lacks what a recording has");
    }
    return statement.integer(0);
}

void Database::roll_back() noexcept {
    sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr); // fails when SQLite has done so already
}

bool Database::has_moved() const {
    int moved = 0;
    check(sqlite3_file_control(connection_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved));
    return moved != 0;
}

} // namespace engine
