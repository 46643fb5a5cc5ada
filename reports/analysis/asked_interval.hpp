#pragma once

// How far the area and the mean gap of a load step may be from those of the
// surface: the parts that follow from what a run has computed anyway, and the
// names of those that do not.

#include "input/types/case.hpp"
#include "results/types/result.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::theory {
class PerssonContact;
}

namespace asperity::reports {

/// One source of error of an answer.
struct IntervalPart {
  std::string name;      ///< "short waves"
  bool is_known = false; ///< whether the intervals contain it
  std::string text;      ///< how it is estimated, or what would tell it
};

/// Half-widths of an interval.
struct HalfWidths {
  double area = 0.0; ///< of A/A_0 [1]
  double gap = 0.0;  ///< of the mean gap [m]
};

/// The intervals of the load steps of one method.
///
/// - Grid: the counted area has an error of first order in the spacing. The
///   correction leaves a part of it (docs/numerics/area.md); the half-width is
///   the correction itself. The mean gap converges an order faster.
/// - Solver: the certified bound of the mean gap on the grid.
/// - Short waves, of a map: the waves of the shortest reliable octave and those
///   beyond it make the rms slope larger by a factor, and the octave that the
///   map does not resolve is taken to have the same. By Persson's theory, at
///   the load at which it has the area of the step, the area changes by the
///   larger of what removing and adding such an octave does, and the gap by
///   what removing it does, absolutely or relative to the gap of the step,
///   whichever is more.
/// - Realisations: the caller adds their spread.
class AskedIntervals {
public:
  /// The result must outlive it.
  AskedIntervals(const results::Result& result, const cases::Case& contact_case,
                 const results::MethodRecord& method);

  /// Without the spread of the realisations; a part that is not known counts 0.
  /// @param row  a converged step of the method
  HalfWidths of(const results::CurvePoint& row) const;

  /// In the order in which a page lists them.
  const std::vector<IntervalPart>& parts() const { return parts_; }

private:
  void add_short_waves(const results::Result& result);

  std::vector<IntervalPart> parts_;
  /// Theories with all waves of the map and without the shortest ones; both or
  /// none.
  std::shared_ptr<const theory::PerssonContact> all_, long_;
};

/// "The intervals contain: grid of the area, solver; not: level and form."; ""
/// without parts.
std::string parts_sentence(const std::vector<IntervalPart>& parts);

} // namespace asperity::reports
