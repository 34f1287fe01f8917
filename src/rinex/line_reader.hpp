#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "rinex/gnss_time.hpp"

namespace multipath_localization {

/// A RINEX file that cannot be used. The text names the file, the line and the reason.
class RinexError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that ends in the middle of something, as logs do when the power goes.
class UnexpectedEnd : public RinexError {
 public:
  explicit UnexpectedEnd(const RinexError& error) : RinexError(error) {}
};

/// Reads a file of fixed columns, which are counted from 0 here, line by line. Marks that editors and DOS
/// leave at the begin of a file (a byte order mark) and at its end (^Z) are no part of the lines. All throw
/// RinexError.
class LineReader {
 public:
  explicit LineReader(const std::string& file);

  /// Goes to the next line; false at the end of the file. Throws UnexpectedEnd at a last line without an end,
  /// whose last number may lack digits. Of longer lines only the first 20 000 characters are there.
  bool next();

  /// The same, where the file must not end: throws UnexpectedEnd.
  void require_next(const char* within);

  /// Makes `next` give the same line again, or throw the same.
  void put_back() { kept_ = true; }

  /// The current line, without its end.
  [[nodiscard]] const std::string& line() const { return line_; }

  /// These columns, as far as the line goes.
  [[nodiscard]] std::string_view columns(std::size_t first, std::size_t width) const;

  /// The same without blanks round it.
  [[nodiscard]] std::string text(std::size_t first, std::size_t width) const;

  /// The number there, its exponent marked by E or D; nothing where the columns are blank.
  [[nodiscard]] std::optional<double> number(std::size_t first, std::size_t width) const {
    return number(columns(first, width));
  }
  [[nodiscard]] std::optional<double> number(std::string_view field) const;

  /// The integer there; blank columns are refused as anything else is.
  [[nodiscard]] int integer(std::size_t first, std::size_t width) const;

  /// Whether the header label at column 60 is that, or as much of it (from 9 characters on) as the line has.
  [[nodiscard]] bool labelled(const std::string& label) const;

  /// Moves what stands from column `from` on to column `to` of the current line.
  void move(std::size_t from, std::size_t to);

  /// The number of the current line, of the one before when it was put back.
  [[nodiscard]] std::size_t line_number() const { return kept_ ? number_ - 1 : number_; }

  /// An error at the current line, at the one before when it was put back; and at any line.
  [[nodiscard]] RinexError error(const std::string& reason) const { return error(line_number(), reason); }
  [[nodiscard]] RinexError error(std::size_t line, const std::string& reason) const;

 private:
  bool read();

  std::string file_;
  std::ifstream in_;
  std::string line_;
  std::size_t number_ = 0;
  bool cut_ = false;
  bool kept_ = false;
};

/// What the first line of a RINEX file says.
struct FileKind {
  double version = 0.0;
  char type = ' ';    ///< O: observations, N, G, ...: navigation
  char system = ' ';  ///< letter of the satellite system, M: several, blank: GPS

  [[nodiscard]] bool version_2() const { return version < 3.0; }
};

/// Whether the current line is a first one.
bool begins_file(const LineReader& in);

/// What the current line says as a first one. Throws RinexError for all but RINEX 2.00 to 2.12 and 3.00 to
/// 3.05.
FileKind kind_of(const LineReader& in);

/// The same of the next line.
FileKind read_kind(LineReader& in);

/// Date and time in columns of width 2 and a blank each (the year of 4 where `digits_of_year` is), seconds in
/// the last `width_of_second` columns. Throws RinexError.
CalendarTime calendar_time(const LineReader& in, std::size_t first, std::size_t digits_of_year,
                           std::size_t width_of_second);

}  // namespace multipath_localization
