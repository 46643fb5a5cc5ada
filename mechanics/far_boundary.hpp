#pragma once

// The boundaries of a block: the one opposite to the contact surface, and the
// border of that surface.

namespace asperity::mechanics {

/// `clamped` has no displacement; `sliding` has no normal displacement and no
/// shear traction; `pressure` has a uniform normal traction, which balances the
/// contact pressure, and no shear traction.
enum class FarBoundary { clamped, sliding, pressure };

/// What lies beyond the border of a map: its periodic continuation, which also
/// continues a cell that is mirrored into itself, or a surface that carries no
/// pressure and lets no fluid pass.
enum class Border { periodic, free };

} // namespace asperity::mechanics
