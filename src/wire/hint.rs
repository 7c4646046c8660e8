//! Which name was meant by one that is not known: the field of a textbook's symbol, the one with another unit, or the one that
//! differs by a slip of the pen.

use super::shortened;

/// Symbols and words of the field, with the names that stand for them. A name that is listed means nothing else: near
/// spellings (`phi` and `k_phi`) lead astray.
const SYNONYMS: &[(&str, &str)] = &[
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
];

/// Endings of names in other units: the ending, the one with the unit that is taken, that unit, and what one is of the other.
const UNITS: &[(&str, &str, &str, &str)] = &[
    ("_mm", "_m", "m", "1 mm is 0.001 m"),
    ("_cm", "_m", "m", "1 cm is 0.01 m"),
    ("_kpa", "_pa", "Pa", "1 kPa is 1000 Pa"),
    ("_mpa", "_pa", "Pa", "1 MPa is 1000000 Pa"),
    ("_deg", "_rad", "rad", "1° is 0.017453293 rad"),
    ("_degrees", "_rad", "rad", "1° is 0.017453293 rad"),
    ("_kn", "_n", "N", "1 kN is 1000 N"),
    ("_kg", "_n", "N", "a mass of 1 kg weighs 9.80665 N on the Earth"),
    ("_kn_m3", "_n_m3", "N/m³", "1 kN/m³ is 1000 N/m³"),
    ("_km_h", "_m_s", "m/s", "1 km/h is 0.2777778 m/s"),
    ("_rpm", "_rad_s", "rad/s", "1 rpm is 0.10471976 rad/s"),
    ("_deg_s", "_rad_s", "rad/s", "1°/s is 0.017453293 rad/s"),
    ("_ms", "_s", "s", "1 ms is 0.001 s"),
    ("_percent", "", "a share", "1 % is 0.01"),
    ("_pct", "", "a share", "1 % is 0.01"),
];

/// The known word that was probably meant by `word`, if one was.
pub(crate) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let word = shortened(word);
    if let Some(&(_, meant)) = SYNONYMS.iter().find(|(synonym, _)| *synonym == word) {
        return known.iter().copied().find(|candidate| *candidate == meant);
    }
    /// A letter or two are in, or near to, too many names.
    const SHORTEST: usize = 3;
    let length = word.chars().count();
    if length < SHORTEST {
        return None;
    }
    let resemblance = |candidate: &str| {
        // A part of a name (`radius` for `radius_m`) is as good a hint as a typo.
        let part = candidate.len() >= SHORTEST && (candidate.contains(&word) || word.contains(candidate));
        let is_typo = strsim::damerau_levenshtein(&word, candidate) <= (length / 3).max(1);
        let share = strsim::normalized_damerau_levenshtein(&word, candidate) + if part { 0.5 } else { 0.0 };
        (part || is_typo).then_some(share)
    };
    let candidates = known.iter().copied().filter_map(|candidate| Some((resemblance(candidate)?, candidate)));
    candidates.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, candidate)| candidate)
}

/// What to say of a field that is not known: of `known` fields, of which some are objects with fields of their own, `within`.
pub(super) fn unknown_field(name: &str, known: &[&str], within: &[(&'static str, &'static [&'static str])]) -> String {
    let name = shortened(name);
    if let Some(hint) = in_another_unit(&name, known) {
        return hint;
    }
    let meant = SYNONYMS.iter().find(|(synonym, _)| *synonym == name).map_or(name.as_str(), |(_, meant)| meant);
    if !known.contains(&meant)
        && let Some((object, _)) = within.iter().find(|(_, names)| names.contains(&meant))
    {
        return format!("`{meant}` belongs in `{object}`");
    }
    match nearest(&name, known) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("known are {}", known.join(", ")),
    }
}

/// The hint for a name that ends in another unit than a known one.
fn in_another_unit(name: &str, known: &[&str]) -> Option<String> {
    let lower = name.to_ascii_lowercase();
    UNITS.iter().find_map(|(ending, own, unit, conversion)| {
        let stem = lower.strip_suffix(ending)?;
        let meant = SYNONYMS.iter().find(|(synonym, _)| *synonym == stem).map(|(_, meant)| *meant);
        let field = known.iter().find(|field| field.strip_suffix(own) == Some(stem) || meant == Some(*field))?;
        Some(format!("`{field}` is in {unit}: {conversion}").replace("is in a share", "is a share"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHEEL: [&str; 4] = ["radius_m", "width_m", "lug_height_m", "lug_coefficient"];
    const SOIL: [&str; 5] = ["preset", "cohesion_pa", "friction_angle_rad", "shear_modulus_m", "pressure_sinkage"];
    const LAW: [&str; 8] = ["law", "k_c", "k_phi", "k_s", "unit_weight_n_m3", "n0", "n1", "n2"];

    #[test]
    fn the_nearest_name_is_the_one_meant() {
        for (word, meant) in
            [("radius", "radius_m"), ("raduis_m", "radius_m"), ("lug_hieght_m", "lug_height_m"), ("r", "radius_m")]
        {
            assert_eq!(nearest(word, &WHEEL), Some(meant));
        }
        for (word, known) in [("colour", &WHEEL[..]), ("", &WHEEL), ("x", &WHEEL), ("m", &WHEEL), ("slip", &["wheel", "soil"])] {
            assert_eq!(nearest(word, known), None, "{word}");
        }
        assert_eq!(nearest("exact", &["quadrature", "linearised", "explicit"]), Some("quadrature"));
        assert_eq!(nearest("linearized", &["quadrature", "linearised", "explicit"]), Some("linearised"));
    }

    #[test]
    fn symbols_of_textbooks_are_the_fields_that_stand_for_them() {
        for (symbol, field) in
            [("phi", "friction_angle_rad"), ("c", "cohesion_pa"), ("K", "shear_modulus_m"), ("k", "shear_modulus_m")]
        {
            assert_eq!(nearest(symbol, &SOIL), Some(field));
        }
        assert_eq!(nearest("bekker", &SOIL), Some("pressure_sinkage"));
        assert_eq!(nearest("n", &LAW), Some("n0"));
        assert_eq!(nearest("phi", &LAW), None, "k_phi is another quantity");
    }

    #[test]
    fn a_name_in_another_unit_is_told_the_unit() {
        assert_eq!(unknown_field("radius_mm", &WHEEL, &[]), "`radius_m` is in m: 1 mm is 0.001 m");
        assert!(unknown_field("friction_angle_deg", &SOIL, &[]).starts_with("`friction_angle_rad` is in rad: 1° is 0.01745"));
        assert_eq!(unknown_field("phi_deg", &SOIL, &[]), unknown_field("friction_angle_deg", &SOIL, &[]));
        assert_eq!(unknown_field("cohesion_kPa", &SOIL, &[]), "`cohesion_pa` is in Pa: 1 kPa is 1000 Pa");
        assert_eq!(unknown_field("slip_percent", &["slip"], &[]), "`slip` is a share: 1 % is 0.01");
        assert!(unknown_field("colour_mm", &WHEEL, &[]).starts_with("known are"));
    }

    #[test]
    fn a_field_of_an_object_is_told_where_it_belongs() {
        let within: [(&str, &[&str]); 1] = [("pressure_sinkage", &LAW)];
        assert_eq!(unknown_field("k_c", &SOIL, &within), "`k_c` belongs in `pressure_sinkage`");
        assert_eq!(unknown_field("n", &SOIL, &within), "`n0` belongs in `pressure_sinkage`");
        assert_eq!(unknown_field("phi", &SOIL, &within), "did you mean `friction_angle_rad`?");
    }
}
