#pragma once

// Which nodes of a load step are in contact, through which a fluid passes, and
// what lies beyond the border of their map: decided here once, for the area,
// the perimeter, spots, conductance, flow, friction, certificates, the maps of
// a report, and, by the attributes of a result file, for Python.

#include "mechanics/far_boundary.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::mechanics {

/// The field by which contact is decided.
enum class ContactField {
  /// In contact where p > 0: laws without tension, whose open nodes have
  /// exactly p = 0.
  pressure,
  /// In contact where g <= 0: laws with adhesion, whose open nodes have tension
  /// or the roundoff error of none, and atoms, all of which have a pressure.
  gap,
};

/// "pressure" or "gap", as in a result file.
inline const char* name_of(ContactField field) {
  return field == ContactField::pressure ? "pressure" : "gap";
}

/// How the contact of a method is decided.
struct ContactCriterion {
  ContactField field = ContactField::pressure;
  /// The largest gap that the solver may leave as an error [m] >= 0: what is
  /// open up to it lets no fluid pass.
  double gap_tolerance = 0.0;

  /// Whether a node with this value of the field is in contact [Pa] or [m].
  bool holds(double value) const {
    return field == ContactField::pressure ? value > 0.0 : value <= 0.0;
  }
};

/// The nodes of a load step, each of which is in contact, open, or neither: a
/// node that carries no pressure and whose gap is within the tolerance. A view
/// of fields in their order, which must outlive it.
class ContactNodes {
public:
  /// @param pressure  [Pa], may be empty if the criterion asks for the gap
  /// @param gap       [m], may be empty if no gap is asked for
  ContactNodes(const ContactCriterion& criterion,
               std::span<const double> pressure, std::span<const double> gap)
      : criterion_(criterion),
        field_(criterion.field == ContactField::pressure ? pressure : gap),
        gap_(gap) {}

  /// Nodes in contact where a pressure is > 0.
  static ContactNodes under(std::span<const double> pressure) {
    return {{}, pressure, {}};
  }

  std::size_t size() const { return field_.size(); }

  const ContactCriterion& criterion() const { return criterion_; }

  /// The field by which contact is decided.
  std::span<const double> field() const { return field_; }

  bool in_contact(std::size_t node) const {
    return criterion_.holds(field_[node]);
  }

  bool is_open(std::size_t node) const {
    return !in_contact(node) && gap_[node] > criterion_.gap_tolerance;
  }

  /// 1 at nodes in contact.
  std::vector<std::uint8_t> contact_set() const;

  /// 1 at open nodes.
  std::vector<std::uint8_t> open_set() const;

  /// The gaps of open nodes, and 0 at all others [m].
  std::vector<double> open_gaps() const;

private:
  ContactCriterion criterion_;
  std::span<const double> field_, gap_;
};

} // namespace asperity::mechanics
