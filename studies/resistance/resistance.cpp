#include "studies/resistance/resistance.hpp"

#include "studies/conductance/conductance.hpp"

#include <cmath>

namespace asperity::studies {
namespace {

/// Faces without contact have no finite resistance: NaN.
double inverse(double conductance) {
  const double resistance = 1.0 / conductance;
  return std::isfinite(resistance) ? resistance : results::not_given;
}

void set_resistances(const cases::Case&, results::CurvePoint& row) {
  columns::thermal_resistance.set(row,
                                  inverse(row[columns::thermal_conductance]));
  columns::electrical_resistance.set(
      row, inverse(row[columns::electrical_conductance]));
}

/// It has no keys of its own: it answers [conductance], too, after it.
const cases::StudyKeys& resistance_keys() {
  static const cases::StudyKeys keys{
      .tables = {}, .read = nullptr, .is_asked = asks<ConductanceStudy>};
  return keys;
}

} // namespace

const Study resistance_study{.keys = resistance_keys,
                             .pages = resistance_pages,
                             .rescale = set_resistances};

} // namespace asperity::studies
