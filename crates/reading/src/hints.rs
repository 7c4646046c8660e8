//! Which name was meant by one that is not known: the field of a textbook's symbol, the one with another unit, or the one that
//! differs by a slip of the pen.

/// The words of a field of knowledge.
#[derive(Debug)]
pub struct Hints {
    /// Symbols and words, with the names that stand for them. A name that is listed means nothing else: near spellings lead
    /// astray.
    pub synonyms: &'static [(&'static str, &'static str)],
    /// Units in which names often end.
    pub units: &'static [OtherUnit],
}

/// A unit in which a number is not taken.
#[derive(Debug)]
pub struct OtherUnit {
    /// The ending of names in that unit: `_mm`.
    pub ending: &'static str,
    /// The ending of names in the unit that is taken: `_m`.
    pub own: &'static str,
    /// What numbers of that name are: `in m`, or `a share`.
    pub unit: &'static str,
    /// What one is of the other: `1 mm is 0.001 m`.
    pub conversion: &'static str,
}

/// What was probably meant by the name of a field that is not known.
enum Meant<'k> {
    /// A field in another unit, with what to say of it.
    InAnotherUnit(String),
    /// A field of that object.
    Within(&'static str, &'static str),
    Near(&'k str),
    Nothing,
}

impl Hints {
    /// No words.
    pub const NONE: Self = Self { synonyms: &[], units: &[] };

    fn meant(&self, word: &str) -> Option<&'static str> {
        self.synonyms.iter().find(|(synonym, _)| *synonym == word).map(|(_, meant)| *meant)
    }

    /// The known word that was probably meant by `word`, if one was.
    ///
    /// ```
    /// use terramechanics_reading::Hints;
    /// assert_eq!(Hints::NONE.nearest("raduis_m", &["radius_m", "width_m"]), Some("radius_m"));
    /// assert_eq!(Hints::NONE.nearest("colour", &["radius_m", "width_m"]), None);
    /// ```
    #[must_use]
    pub fn nearest<'a>(&self, word: &str, known: &[&'a str]) -> Option<&'a str> {
        let word = shortened(word);
        if let Some(meant) = self.meant(&word) {
            return known.iter().copied().find(|candidate| *candidate == meant);
        }
        if let Some(same) = known.iter().copied().find(|candidate| candidate.eq_ignore_ascii_case(&word)) {
            return Some(same);
        }
        /// A letter or two are in, or near to, too many names.
        const SHORTEST: usize = 3;
        let length = word.chars().count();
        if length < SHORTEST {
            return None;
        }
        let resemblance = |candidate: &str| {
            let part = candidate.len() >= SHORTEST && (candidate.contains(&word) || word.contains(candidate));
            let typos = strsim::damerau_levenshtein(&word, candidate);
            // A part of a name (`radius` for `radius_m`) is as good a hint as a single typo.
            let bonus = if part || typos <= 1 { 0.5 } else { 0.0 };
            let share = strsim::normalized_damerau_levenshtein(&word, candidate) + bonus;
            (part || typos <= (length / 3).max(1)).then_some(share)
        };
        let candidates = known.iter().copied().filter_map(|candidate| Some((resemblance(candidate)?, candidate)));
        candidates.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, candidate)| candidate)
    }

    /// What to say of a field that is not known: of `known` fields, of which some are objects with fields of their own, `within`.
    #[must_use]
    pub fn unknown_field(&self, name: &str, known: &[&str], within: &[(&'static str, Vec<&'static str>)]) -> String {
        match self.field_meant(name, known, within) {
            Meant::InAnotherUnit(hint) => hint,
            Meant::Within(object, meant) => format!("`{meant}` belongs in `{object}`"),
            Meant::Near(near) => format!("did you mean `{near}`?"),
            Meant::Nothing => format!("known are {}", known.join(", ")),
        }
    }

    /// The same where fields are named by their JSON pointers, of which those of `known` begin with `around`.
    pub(crate) fn unknown_pointer(
        &self,
        around: &str,
        name: &str,
        known: &[&str],
        within: &[(&'static str, Vec<&'static str>)],
    ) -> String {
        match self.field_meant(name, known, within) {
            Meant::InAnotherUnit(hint) => hint,
            Meant::Within(object, meant) => format!("did you mean `{around}/{object}/{meant}`?"),
            Meant::Near(near) => format!("did you mean `{around}/{near}`?"),
            Meant::Nothing => format!("known are {}", known.join(", ")),
        }
    }

    /// The field that was probably meant by one that is not known.
    fn field_meant<'k>(&self, name: &str, known: &[&'k str], within: &[(&'static str, Vec<&'static str>)]) -> Meant<'k> {
        let name = shortened(name);
        if let Some(hint) = self.in_another_unit(&name, known) {
            return Meant::InAnotherUnit(hint);
        }
        let meant = self.meant(&name).unwrap_or(&name);
        let inside = within.iter().find_map(|(object, names)| Some((*object, *names.iter().find(|name| **name == meant)?)));
        match inside {
            Some((object, meant)) if !known.contains(&meant) => Meant::Within(object, meant),
            _ => self.nearest(&name, known).map_or(Meant::Nothing, Meant::Near),
        }
    }

    /// The hint for a name that ends in another unit than a known one.
    fn in_another_unit(&self, name: &str, known: &[&str]) -> Option<String> {
        let lower = name.to_ascii_lowercase();
        self.units.iter().find_map(|OtherUnit { ending, own, unit, conversion }| {
            let stem = lower.strip_suffix(ending)?;
            let meant = self.meant(stem);
            let field = known.iter().find(|field| field.strip_suffix(own) == Some(stem) || meant == Some(*field))?;
            Some(format!("`{field}` is {unit}: {conversion}"))
        })
    }
}

/// A client's word, cut to a length that is fit for a message.
#[must_use]
pub fn shortened(word: &str) -> String {
    const LONGEST: usize = 60;
    match word.char_indices().nth(LONGEST) {
        None => word.to_owned(),
        Some((end, _)) => word[..end].chars().chain(['…']).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HINTS: Hints = Hints {
        synonyms: &[
            ("phi", "friction_angle_rad"),
            ("c", "cohesion_pa"),
            ("n", "n0"),
            ("r", "radius_m"),
            ("bekker", "pressure_sinkage"),
            ("exact", "quadrature"),
        ],
        units: &[
            OtherUnit { ending: "_mm", own: "_m", unit: "in m", conversion: "1 mm is 0.001 m" },
            OtherUnit { ending: "_kpa", own: "_pa", unit: "in Pa", conversion: "1 kPa is 1000 Pa" },
            OtherUnit { ending: "_deg", own: "_rad", unit: "in rad", conversion: "1° is 0.017453293 rad" },
            OtherUnit { ending: "_percent", own: "", unit: "a share", conversion: "1 % is 0.01" },
        ],
    };
    const WHEEL: [&str; 4] = ["radius_m", "width_m", "lug_height_m", "lug_coefficient"];
    const SOIL: [&str; 5] = ["preset", "cohesion_pa", "friction_angle_rad", "shear_modulus_m", "pressure_sinkage"];
    const LAW: [&str; 8] = ["law", "k_c", "k_phi", "k_s", "unit_weight_n_m3", "n0", "n1", "n2"];

    #[test]
    fn the_nearest_name_is_the_one_meant() {
        for (word, meant) in
            [("radius", "radius_m"), ("raduis_m", "radius_m"), ("lug_hieght_m", "lug_height_m"), ("r", "radius_m")]
        {
            assert_eq!(HINTS.nearest(word, &WHEEL), Some(meant));
        }
        for (word, known) in [("colour", &WHEEL[..]), ("", &WHEEL), ("x", &WHEEL), ("m", &WHEEL), ("slip", &["wheel", "soil"])] {
            assert_eq!(HINTS.nearest(word, known), None, "{word}");
        }
        let methods = ["quadrature", "linearised", "explicit"];
        assert_eq!(HINTS.nearest("EXPLICIT", &methods), Some("explicit"));
        assert_eq!(HINTS.nearest("N0", &LAW), Some("n0"));
        assert_eq!(HINTS.nearest("exact", &methods), Some("quadrature"));
        assert_eq!(HINTS.nearest("linearized", &methods), Some("linearised"));
    }

    #[test]
    fn symbols_are_the_fields_that_stand_for_them_and_nothing_else() {
        for (symbol, field) in [("phi", "friction_angle_rad"), ("c", "cohesion_pa"), ("bekker", "pressure_sinkage")] {
            assert_eq!(HINTS.nearest(symbol, &SOIL), Some(field));
        }
        assert_eq!(HINTS.nearest("n", &LAW), Some("n0"));
        assert_eq!(HINTS.nearest("phi", &LAW), None, "k_phi is another quantity");
    }

    #[test]
    fn a_name_in_another_unit_is_told_the_unit() {
        let said = |name: &str, known: &[&str]| HINTS.unknown_field(name, known, &[]);
        assert_eq!(said("radius_mm", &WHEEL), "`radius_m` is in m: 1 mm is 0.001 m");
        assert!(said("friction_angle_deg", &SOIL).starts_with("`friction_angle_rad` is in rad: 1° is 0.01745"));
        assert_eq!(said("phi_deg", &SOIL), said("friction_angle_deg", &SOIL));
        assert_eq!(said("cohesion_kPa", &SOIL), "`cohesion_pa` is in Pa: 1 kPa is 1000 Pa");
        assert_eq!(said("slip_percent", &["slip"]), "`slip` is a share: 1 % is 0.01");
        assert!(said("colour_mm", &WHEEL).starts_with("known are"));
    }

    #[test]
    fn a_field_of_an_object_is_told_where_it_belongs() {
        let within = [("pressure_sinkage", LAW.to_vec())];
        assert_eq!(HINTS.unknown_field("k_c", &SOIL, &within), "`k_c` belongs in `pressure_sinkage`");
        assert_eq!(HINTS.unknown_field("n", &SOIL, &within), "`n0` belongs in `pressure_sinkage`");
        assert_eq!(HINTS.unknown_field("phi", &SOIL, &within), "did you mean `friction_angle_rad`?");
    }

    #[test]
    fn a_long_word_is_cut() {
        assert_eq!(shortened(&"ä".repeat(100)).chars().count(), 61);
        assert_eq!(shortened("short"), "short");
    }
}
