//! Where the letter as printed is not what is computed, with a proof from the letter's own equations.
//!
//! The docs of this crate cite these by number.

/// A place where the letter as printed is not what is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Erratum {
    /// Its number.
    pub number: u8,
    /// What is printed, and where.
    pub printed: &'static str,
    /// Why that is an error.
    pub reason: &'static str,
    /// What is computed instead.
    pub computed: &'static str,
}

/// Every erratum, by its number from 1.
pub const ERRATA: &[Erratum] = &[
    Erratum {
        number: 1,
        printed: "(3) is called the rear region, (4) the front",
        reason: "θm to θ1 lies ahead of the peak",
        computed: "the regions by their angles, names swapped",
    },
    Erratum {
        number: 2,
        printed: "(6): exponent r/V",
        reason: "V is defined nowhere; the text calls K the soil's shear coefficient",
        computed: "r/K",
    },
    Erratum {
        number: 3,
        printed: "(10) and X in (11): the normal stress is scaled by r_s",
        reason: "(15) and (16) follow from (11), (12) and (14) only with X = r b σm: their first and second terms carry no r_s/r",
        computed: "r; with normal_stress_radius = shearing, r_s",
    },
    Erratum {
        number: 4,
        printed: "(10b): τ sin θ − σ cos θ",
        reason: "F_z = A X + B Y in (11b) needs the sum: the soil pushes up",
        computed: "τ sin θ + σ cos θ",
    },
    Erratum {
        number: 5,
        printed: "(10c): lower limit θ1",
        reason: "the integral would be zero, and H in (12c) needs θ2",
        computed: "from θ2 to θ1",
    },
    Erratum { number: 6, printed: "(11c): T = r H Y", reason: "(10c) and (17) carry r_s² in all", computed: "T = r_s H Y" },
    Erratum {
        number: 7,
        printed: "(13): θ1 = arccos(1 − z/r)/2",
        reason: "(3) with z(0) = z gives the full angle; the half belongs to H = θ1/2, which gives (17)",
        computed: "θ1 = arccos(1 − z/r)",
    },
    Erratum {
        number: 8,
        printed: "(14b): z/(2π)",
        reason: "B has no dimension; for small angles B tends to z/(2r), which (15) and (16) use",
        computed: "z/(2r)",
    },
    Erratum {
        number: 9,
        printed: "(15): r_s √r, twice",
        reason: "that is no force but N·m; A Y from (11) and (14a) gives r_s/√r",
        computed: "r_s/√r",
    },
    Erratum { number: 10, printed: "(15): capital C", reason: "(5), (16) and (17) write c for the cohesion", computed: "c" },
    Erratum {
        number: 11,
        printed: "(6) when braking: 1 − s",
        reason: "the braking slip of (2) gives v/(r ω) = 1/(1 + s); j turns negative and 1 − exp(−j/K) would grow without bound",
        computed: "κ = 1/(1 + s) and the signed E",
    },
    Erratum {
        number: 12,
        printed: "caption of Fig. 1: kN/m^(3+1), kN/m^(3+2)",
        reason: "Bekker's moduli are per m^(n+1) and m^(n+2)",
        computed: "n",
    },
    Erratum {
        number: 13,
        printed: "(6): the displacement is counted on the rim, r",
        reason: "(9) and (10) let the shear stress act at r_s, and one body of soil cannot slide on two circles; the models that \
                 the letter simplifies count it where the stress acts. With the rim, wheels with lugs pull too little",
        computed: "r_s, from where that circle enters the soil; with shear_displacement_radius = rim, r",
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_errata_are_numbered_from_one() {
        for (i, erratum) in ERRATA.iter().enumerate() {
            assert_eq!(usize::from(erratum.number), i + 1, "{}", erratum.printed);
        }
    }
}
