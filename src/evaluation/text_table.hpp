#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace multipath_localization {

/// A title and a cell for each line; all columns of a table are as long.
using TextColumn = std::vector<std::string>;

/// The columns beside each other, line by line. The first `names` of them begin, the others end at the same
/// place in every line.
std::string side_by_side(const std::vector<TextColumn>& columns, std::size_t names);

/// A number with that many digits after the point; from a million on in powers of ten.
std::string number(double value, int digits);

/// The same with one digit more where two would leave next to nothing, as of errors of RTK.
std::string figure(double value, int digits);

}  // namespace multipath_localization
