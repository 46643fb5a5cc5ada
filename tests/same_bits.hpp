#pragma once

// Comparison of two results, bit by bit.

#include "results/result_reader.hpp"
#include "results/types/curve_columns.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace asperity::tests {

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline void expect_same_rows(const std::vector<results::CurvePoint>& one,
                             const std::vector<results::CurvePoint>& other,
                             bool costs_too) {
  ASSERT_EQ(one.size(), other.size());
  for (const results::CurveColumn& column : results::curve_columns())
    for (std::size_t i = 0; i < one.size(); ++i) {
      const bool is_cost = column.name.ends_with("_time");
      EXPECT_TRUE((is_cost && !costs_too) ||
                  same_bits(column.get(one[i]), column.get(other[i])))
          << i << ' ' << column.name;
    }
}

/// Every number of every row and map, bit by bit; the costs if requested.
inline void expect_same_bits(const results::Result& one,
                             const results::Result& other,
                             bool costs_too = false) {
  ASSERT_EQ(one.methods.size(), other.methods.size());
  for (std::size_t m = 0; m < one.methods.size(); ++m)
    for (std::size_t r = 0; r < one.methods[m].realizations.size(); ++r) {
      const results::Curve& a = one.methods[m].realizations[r];
      const results::Curve& b = other.methods.at(m).realizations.at(r);
      expect_same_rows(a.points, b.points, costs_too);
      EXPECT_TRUE(!costs_too || a.setup_cpu_time == b.setup_cpu_time);
      ASSERT_EQ(a.fields.size(), b.fields.size());
      for (std::size_t i = 0; i < a.fields.size(); ++i) {
        EXPECT_EQ(a.fields[i].pressure, b.fields[i].pressure);
        EXPECT_EQ(a.fields[i].gap, b.fields[i].gap);
      }
    }
}

} // namespace asperity::tests
