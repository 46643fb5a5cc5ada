#pragma once

// The condition on the far boundary of a block, opposite to the contact
// surface.

namespace asperity::mechanics {

/// `clamped` has no displacement; `sliding` has no normal displacement and no
/// shear traction; `pressure` has a uniform normal traction, which balances the
/// contact pressure, and no shear traction.
enum class FarBoundary { clamped, sliding, pressure };

} // namespace asperity::mechanics
