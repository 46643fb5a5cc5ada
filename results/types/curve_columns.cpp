#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace asperity::results {
namespace {

constexpr double rounding = 1e-9; // of sums of weights whose mean is 1

using Columns = std::vector<std::reference_wrapper<const CurveColumn>>;

Columns& known_columns() {
  static Columns columns;
  return columns;
}

/// The number of that column among those that are no members, or the end.
template <class Numbers>
auto number_of(Numbers& numbers, const CurveColumn& column) {
  return std::ranges::find_if(
      numbers, [&](const auto& one) { return one.first == &column; });
}

} // namespace

bool ColumnRange::holds(double number) const {
  const double allowed = highest == 1.0 ? rounding : 0.0;
  return number >= lowest - allowed && number <= highest + allowed;
}

std::string ColumnRange::text() const {
  if (highest < largest_number)
    return fmt::format("must lie between {} and {}", lowest, highest);
  return lowest == 0.0 ? "must be finite and >= 0" : "must be finite";
}

CurveColumn::CurveColumn(std::string_view owner, const ColumnTraits& traits,
                         Member member)
    : ColumnTraits(traits), owner_(owner), member_(member) {
  if (find_curve_column(name) != nullptr)
    throw std::logic_error(fmt::format("there are two columns {}", name));
  Columns& known = known_columns();
  known.insert(std::ranges::upper_bound(
                   known, owner_, {},
                   [](const CurveColumn& one) { return one.owner(); }),
               *this);
}

CurveColumn::~CurveColumn() {
  std::erase_if(known_columns(),
                [&](const CurveColumn& one) { return &one == this; });
}

DirectedColumn::DirectedColumn(std::string_view owner, ColumnTraits traits)
    : name_x_(fmt::format("{}_x", traits.name)),
      name_y_(fmt::format("{}_y", traits.name)),
      x(owner, (traits.name = name_x_, traits)),
      y(owner,
        (traits.name = name_y_, traits.text = "likewise along y", traits)) {}

double CurveColumn::get(const CurvePoint& row) const {
  return std::visit(
      [&](auto member) {
        if constexpr (!std::is_same_v<decltype(member), std::monostate>)
          return static_cast<double>(row.*member);
        const auto found = number_of(row.others_, *this);
        return found == row.others_.end() ? blank() : found->second;
      },
      member_);
}

void CurveColumn::set(CurvePoint& row, double number) const {
  std::visit(
      [&](auto member) {
        if constexpr (std::is_same_v<decltype(member), std::monostate>) {
          const auto found = number_of(row.others_, *this);
          const bool is_blank =
              std::isnan(blank()) ? std::isnan(number) : number == blank();
          if (!is_blank)
            row[*this] = number;
          else if (found != row.others_.end())
            row.others_.erase(found);
        } else {
          using Number = std::remove_reference_t<decltype(row.*member)>;
          if constexpr (std::is_same_v<Number, double>)
            row.*member = number;
          else
            row.*member = static_cast<Number>(static_cast<int>(number));
        }
      },
      member_);
}

double CurvePoint::operator[](const CurveColumn& column) const {
  return column.get(*this);
}

double& CurvePoint::operator[](const CurveColumn& column) {
  if (const auto* const member =
          std::get_if<double CurvePoint::*>(&column.member_))
    return this->**member;
  if (!std::holds_alternative<std::monostate>(column.member_))
    throw std::domain_error(
        fmt::format("{} of a row is not a double", column.name));
  const auto found = number_of(others_, column);
  return found != others_.end()
             ? found->second
             : others_.emplace_back(&column, column.blank()).second;
}

const Columns& curve_columns() {
  return known_columns();
}

const CurveColumn* find_curve_column(std::string_view name) {
  const Columns& known = known_columns();
  const auto found = std::ranges::find(
      known, name, [](const CurveColumn& one) { return one.name; });
  return found == known.end() ? nullptr : &found->get();
}

const CurveColumn& curve_column(std::string_view name) {
  if (const CurveColumn* found = find_curve_column(name))
    return *found;
  throw std::domain_error("a curve has no column " + std::string(name));
}

std::string columns_markdown() {
  std::string page =
      "# Columns of a curve\n\n"
      "This page tells each quantity of a load step that `result.h5`, "
      "`curves.csv` and Python have. A test holds it equal to what the "
      "program knows of its columns. Columns with a name after their unit "
      "belong to a method or a study; a quantity that is not there is NaN, "
      "and 0 if it is a count. Equations are those of Yang and Persson "
      "(2008).\n\n| column | of | content |\n|---|---|---|\n";
  for (const CurveColumn& column : known_columns())
    page += fmt::format("| `{}` [{}] | {} | {} |\n", column.name, column.unit,
                        column.owner(), column.text);
  return page +
         "\nBeside these, `note` is a text: why the step did not converge, and "
         "which quantities are NaN and why.\n";
}

void state_of_map(CurvePoint& row, double share) {
  for (const CurveColumn& one : known_columns())
    if (one.extent == Extent::extensive && !std::isnan(one.get(row)))
      one.set(row, share * one.get(row));
}

std::string_view status_word(StepStatus status) {
  return status == StepStatus::converged ? "converged" : "not_converged";
}

} // namespace asperity::results
