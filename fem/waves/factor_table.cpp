#include "fem/waves/moduli_field.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <algorithm>
#include <sstream>

namespace asperity::fem {

FactorTable read_factor_table(const std::string& path,
                              const std::array<double, 3>& lengths) {
  const surfaces::NumberTable rows = surfaces::read_number_file(path);
  FactorTable table;
  table.lengths = lengths;
  for (const surfaces::CommentLine& comment : rows.comments) {
    std::istringstream words(comment.text);
    std::string word;
    if (words >> word && word == "boxes")
      for (int& count : table.boxes)
        words >> count;
  }
  const auto count = [](int boxes) {
    return static_cast<std::size_t>(std::max(boxes, 0));
  };
  const std::size_t columns = count(table.boxes[0]);
  const std::size_t n_rows = count(table.boxes[1]) * count(table.boxes[2]);
  if (columns == 0 || rows.columns != columns || rows.rows() != n_rows)
    surfaces::refuse_line(path, rows.lines.front(),
                          "expected a line \"# boxes nx ny nz\" and ny nz rows "
                          "of nx factors; found " +
                              std::to_string(rows.rows()) + " rows of " +
                              std::to_string(rows.columns));
  for (std::size_t row = 0; row < rows.rows(); ++row)
    for (std::size_t column = 0; column < columns; ++column)
      if (rows.number(row, column) <= 0.0)
        surfaces::refuse_line(path, rows.lines[row],
                              "factor " +
                                  std::to_string(rows.number(row, column)) +
                                  " of the modulus must be > 0");
  table.factors = rows.numbers;
  return table;
}

} // namespace asperity::fem
