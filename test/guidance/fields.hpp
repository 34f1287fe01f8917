#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace multipath_localization {

/// A field of these tests, by its corners [m].
struct NamedField {
  std::string name;
  std::vector<Eigen::Vector2d> border;
};

inline std::vector<NamedField> fields() {
  return {{"rectangle", {{0.0, 0.0}, {40.0, 0.0}, {40.0, 25.0}, {0.0, 25.0}}},
          {"clockwise", {{5.0, 5.0}, {5.0, 25.0}, {35.0, 25.0}, {35.0, 5.0}}},
          {"four corners", {{0.0, 0.0}, {35.0, 3.0}, {28.0, 20.0}, {4.0, 16.0}}},
          {"L", {{0.0, 0.0}, {30.0, 0.0}, {30.0, 12.0}, {14.0, 12.0}, {14.0, 30.0}, {0.0, 30.0}}},
          {"U",
           {{0.0, 0.0},
            {30.0, 0.0},
            {30.0, 25.0},
            {20.0, 25.0},
            {20.0, 10.0},
            {10.0, 10.0},
            {10.0, 25.0},
            {0.0, 25.0}}},
          {"T",
           {{0.0, 20.0},
            {0.0, 10.0},
            {12.0, 10.0},
            {12.0, 0.0},
            {20.0, 0.0},
            {20.0, 10.0},
            {35.0, 10.0},
            {35.0, 20.0}}}};
}

}  // namespace multipath_localization
