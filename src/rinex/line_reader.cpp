#include "rinex/line_reader.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/plain_numbers.hpp"
#include "support/text.hpp"

namespace multipath_localization {

namespace {

constexpr std::size_t kLongestLine = 20000;  // 999 kinds of observations of 16 columns each

constexpr std::size_t kShortestLabel = 9;  // that still tells

/// With its newline, which the last line may lack. What is too long is not kept: no file fills the memory.
void read_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n' || line.size() < kLongestLine) line += static_cast<char>(c);
    if (c == '\n') return;
  }
}

void drop_end(std::string& line, const char* characters) {
  line.erase(line.find_last_not_of(characters) + 1);
}

}  // namespace

LineReader::LineReader(const std::string& file) : file_(file), in_(file) {
  if (!in_ || in_.peek() == std::ifstream::traits_type::eof()) {
    throw RinexError(file + ": cannot be read or is empty");
  }
}

bool LineReader::next() {
  if (kept_) {
    kept_ = false;
  } else if (!read()) {
    return false;
  }
  if (cut_) throw UnexpectedEnd(error("the file ends within this line"));
  return true;
}

bool LineReader::read() {
  read_line(in_, line_);
  if (in_.bad()) throw error("cannot be read beyond this line");
  if (line_.empty()) return false;
  ++number_;
  cut_ = line_.back() != '\n';
  drop_end(line_, "\r\n\x1a");
  if (line_.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0) line_.erase(0, kByteOrderMark.size());
  return !(cut_ && line_.empty());
}

void LineReader::require_next(const char* within) {
  if (!next()) throw UnexpectedEnd(error(std::string("the file ends within ") + within));
}

std::string_view LineReader::columns(std::size_t first, std::size_t width) const {
  const std::string_view line = line_;
  return first < line.size() ? line.substr(first, width) : std::string_view();
}

std::string LineReader::text(std::size_t first, std::size_t width) const {
  return std::string(trimmed(columns(first, width), " "));
}

std::optional<double> LineReader::number(std::string_view field) const {
  std::string text(trimmed(field, " "));
  if (text.empty()) return std::nullopt;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
  const std::optional<double> value = parse_number(text);
  const bool decimal = text.find_first_not_of("0123456789+-.eE") == std::string::npos;
  if (!decimal || !value || !std::isfinite(*value)) throw error("'" + text + "' is not a number");
  return value;
}

int LineReader::integer(std::size_t first, std::size_t width) const {
  const std::optional<double> value = number(first, width);
  if (!value || *value != std::floor(*value) || std::abs(*value) > 1e6) {
    throw error("'" + text(first, width) + "' is not an integer");
  }
  return static_cast<int>(*value);
}

bool LineReader::labelled(const std::string& label) const {
  const std::string found = text(60, 20);
  return found == label || (found.size() >= kShortestLabel && label.compare(0, found.size(), found) == 0);
}

void LineReader::move(std::size_t from, std::size_t to) {
  if (from < to) line_.insert(from, to - from, ' ');
  if (from > to) line_.erase(to, from - to);
}

RinexError LineReader::error(std::size_t line, const std::string& reason) const {
  return RinexError(file_ + ":" + std::to_string(line) + ": " + reason);
}

bool begins_file(const LineReader& in) { return in.labelled("RINEX VERSION / TYPE"); }

FileKind read_kind(LineReader& in) {
  in.require_next("its first line");
  return kind_of(in);
}

FileKind kind_of(const LineReader& in) {
  if (in.labelled("CRINEX VERS   / TYPE")) throw in.error("compressed by Hatanaka's method; expand it first");
  if (!begins_file(in)) throw in.error("not a RINEX file");
  FileKind kind;
  kind.version = in.number(0, 9).value_or(0.0);
  const bool known =
      (kind.version >= 2.0 && kind.version < 2.125) || (kind.version >= 3.0 && kind.version < 3.055);
  if (!known) {
    throw in.error("RINEX version '" + in.text(0, 9) + "'; 2.00 to 2.12 and 3.00 to 3.05 are read");
  }
  const auto letter = [&](std::size_t column) {
    const std::string_view columns = in.columns(column, 1);
    return columns.empty() ? ' ' : columns.front();
  };
  kind.type = letter(20);
  kind.system = letter(40);
  return kind;
}

CalendarTime calendar_time(const LineReader& in, std::size_t first, std::size_t digits_of_year,
                           std::size_t width_of_second) {
  CalendarTime time;
  time.year = in.integer(first, digits_of_year);
  if (digits_of_year == 2) time.year = year_of_two_digits(time.year);
  const std::size_t month = first + digits_of_year;
  time.month = in.integer(month, 3);
  time.day = in.integer(month + 3, 3);
  time.hour = in.integer(month + 6, 3);
  time.minute = in.integer(month + 9, 3);
  const std::optional<double> second = in.number(month + 12, width_of_second);
  if (!second) throw in.error("no second in the time");
  time.second = *second;
  return time;
}

}  // namespace multipath_localization
