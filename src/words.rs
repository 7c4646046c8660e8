//! The words of the field: symbols of textbooks, habits of speech, and units in which numbers are often sent.

use terramechanics_reading::{Hints, OtherUnit};

/// By them a reader tells which name was meant.
pub(crate) static HINTS: Hints = Hints {
    synonyms: &[
        ("phi", "friction_angle_rad"),
        ("φ", "friction_angle_rad"),
        ("friction", "friction_angle_rad"),
        ("friction_angle", "friction_angle_rad"),
        ("angle_of_internal_friction", "friction_angle_rad"),
        ("c", "cohesion_pa"),
        ("K", "shear_modulus_m"),
        ("k", "shear_modulus_m"),
        ("k_x", "shear_modulus_m"),
        ("K_x", "shear_modulus_m"),
        ("shear_deformation_modulus", "shear_modulus_m"),
        ("K_y", "lateral_shear_modulus_m"),
        ("k_y", "lateral_shear_modulus_m"),
        ("K_r", "residual_ratio"),
        ("K_w", "peak_displacement_m"),
        ("gamma", "unit_weight_n_m3"),
        ("γ", "unit_weight_n_m3"),
        ("bekker", "pressure_sinkage"),
        ("reece", "pressure_sinkage"),
        ("janosi", "shear"),
        ("janosi_hanamoto", "shear"),
        ("n", "n0"),
        ("exponent", "n0"),
        ("kc", "k_c"),
        ("kphi", "k_phi"),
        ("ks", "k_s"),
        ("K_s", "k_s"),
        ("r", "radius_m"),
        ("R", "radius_m"),
        ("b", "width_m"),
        ("h", "lug_height_m"),
        ("s", "slip"),
        ("i", "slip"),
        ("slip_ratio", "slip"),
        ("beta", "slip_angle_rad"),
        ("β", "slip_angle_rad"),
        ("z", "sinkage_m"),
        ("z0", "static_sinkage_m"),
        ("z_0", "static_sinkage_m"),
        ("W", "normal_load_n"),
        ("w", "normal_load_n"),
        ("load", "normal_load_n"),
        ("weight", "normal_load_n"),
        ("F_z", "normal_force_n"),
        ("fz", "normal_force_n"),
        ("F_x", "longitudinal_force_n"),
        ("fx", "longitudinal_force_n"),
        ("drawbar_pull", "longitudinal_force_n"),
        ("T", "torque_n_m"),
        ("t", "time_s"),
        ("v", "forward_velocity_m_s"),
        ("velocity", "forward_velocity_m_s"),
        ("omega", "angular_velocity_rad_s"),
        ("ω", "angular_velocity_rad_s"),
        ("exact", "quadrature"),
        ("integral", "quadrature"),
        ("numerical", "quadrature"),
        ("linear", "linearised"),
    ],
    units: &[
        unit("_mm", "_m", "in m", "1 mm is 0.001 m"),
        unit("_cm", "_m", "in m", "1 cm is 0.01 m"),
        unit("_kpa", "_pa", "in Pa", "1 kPa is 1000 Pa"),
        unit("_mpa", "_pa", "in Pa", "1 MPa is 1000000 Pa"),
        unit("_deg", "_rad", "in rad", "1° is 0.017453293 rad"),
        unit("_degrees", "_rad", "in rad", "1° is 0.017453293 rad"),
        unit("_kn", "_n", "in N", "1 kN is 1000 N"),
        unit("_kg", "_n", "in N", "a mass of 1 kg weighs 9.80665 N on the Earth"),
        unit("_kn_m3", "_n_m3", "in N/m³", "1 kN/m³ is 1000 N/m³"),
        unit("_km_h", "_m_s", "in m/s", "1 km/h is 0.2777778 m/s"),
        unit("_rpm", "_rad_s", "in rad/s", "1 rpm is 0.10471976 rad/s"),
        unit("_deg_s", "_rad_s", "in rad/s", "1°/s is 0.017453293 rad/s"),
        unit("_ms", "_s", "in s", "1 ms is 0.001 s"),
        unit("_percent", "", "a share", "1 % is 0.01"),
        unit("_pct", "", "a share", "1 % is 0.01"),
    ],
};

const fn unit(ending: &'static str, own: &'static str, unit: &'static str, conversion: &'static str) -> OtherUnit {
    OtherUnit { ending, own, unit, conversion }
}

/// The known word that was probably meant by `word`, if one was.
pub(crate) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    HINTS.nearest(word, known)
}
