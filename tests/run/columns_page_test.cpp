// The page of columns is what the program knows of them.
#include "results/types/curve_columns.hpp"
#include "results/types/method_columns.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace asperity::results::columns_page_test {

// ASPERITY_UPDATE_GOLDEN=1 writes the page again.
TEST(ColumnsPage, IsTheCommittedPage) {
  const std::string path = "docs/reference/columns.md";
  if (std::getenv("ASPERITY_UPDATE_GOLDEN") != nullptr)
    std::ofstream(path) << columns_markdown();

  std::ostringstream committed;
  committed << std::ifstream(path).rdbuf();

  EXPECT_EQ(committed.str(), columns_markdown())
      << "write it anew: ASPERITY_UPDATE_GOLDEN=1 ctest -R run/columns_page";
}

// Each column says what it is and what its unit is.
TEST(ColumnsPage, HasATextForEachColumn) {
  for (const CurveColumn& column : curve_columns()) {
    EXPECT_FALSE(column.text.empty()) << column.name;
    EXPECT_FALSE(column.unit.empty()) << column.name;
  }
}

} // namespace asperity::results::columns_page_test
