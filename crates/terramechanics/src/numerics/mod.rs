//! Numerical methods the model needs: nothing here knows of wheels or soils.

pub(crate) mod brent;
pub(crate) mod circular;
pub(crate) mod elementary;
pub(crate) mod gauss_legendre;
pub(crate) mod lanes;
pub(crate) mod level;
