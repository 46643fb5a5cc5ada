#pragma once

// A contact case with further keys of its block, or the messages about them.

#include "input/reader/read_case.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace asperity::cases {

inline Case block(const std::string& keys,
                  const std::vector<std::string>& overrides = {}) {
  return read_case_text(contact_case + keys, "some/case.toml", overrides);
}

inline std::string refusal(const std::string& keys,
                           const std::vector<std::string>& overrides = {}) {
  return mistakes_of(contact_case + keys, overrides);
}

inline const mechanics::FemSettings& fem_of(const Case& read) {
  return std::get<mechanics::FemSettings>(read.methods.at(2).settings);
}

inline const std::vector<std::string> full = {"fem.solver=full"};

struct Refused {
  std::string keys, override, words;
};

class RefusedBlock : public testing::TestWithParam<Refused> {};

TEST_P(RefusedBlock, IsRefusedWithAReason) {
  const std::string answer = refusal(GetParam().keys, {GetParam().override});

  EXPECT_NE(answer.find(GetParam().words), std::string::npos) << answer;
}

} // namespace asperity::cases
