//! Methods by name.

use terramechanics::Method;

/// The name of a method on the wire.
pub(crate) fn method_name(method: &Method) -> &'static str {
    match method {
        Method::Quadrature | Method::SideSlipping(_) => "quadrature",
        Method::Linearised { .. } => "linearised",
        Method::Explicit { .. } => "explicit",
        Method::ResistiveForce => "resistive_force",
    }
}
