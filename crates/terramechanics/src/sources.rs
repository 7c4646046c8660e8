//! The works that the model is made from, numbered: source 2 in the docs of this crate is the second of [`SOURCES`].
//!
//! The text says so where a work was only quoted or read in part. Otherwise the work itself was read, or its formula in a public
//! implementation; the file that uses it says which.

use std::fmt;

/// A work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Its number; 0 is the letter.
    pub number: u8,
    /// Authors and year, as a text names it.
    pub short: &'static str,
    /// The whole reference.
    pub text: &'static str,
}

/// A place in a work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Citation {
    /// The work.
    pub source: &'static Source,
    /// Equation or chapter, where it is known.
    pub place: Option<&'static str>,
}

impl Source {
    /// The work as a whole.
    pub(crate) const fn cited(&'static self) -> Citation {
        Citation { source: self, place: None }
    }

    /// A place in the work.
    pub(crate) const fn at(&'static self, place: &'static str) -> Citation {
        Citation { source: self, place: Some(place) }
    }
}

impl fmt::Display for Citation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.source.short)?;
        self.place.map_or(Ok(()), |place| write!(f, ", {place}"))
    }
}

/// The letter that the model follows; its equations are cited by their numbers alone.
pub const LETTER: Source =
    Source { number: 0, short: "letter", text: "Improving engineering models of terramechanics for planetary exploration." };

pub(crate) const AKIN: Source = Source {
    number: 1,
    short: "Akin 2020",
    text: "Akin, D. L. (2020) Planetary Surface Robotics, ENAE 788X, course material on terramechanics. University of \
           Maryland.",
};

pub(crate) const BEKKER: Source = Source {
    number: 2,
    short: "Bekker 1956, 1960, 1969",
    text: "Bekker, M. G. (1956) Theory of Land Locomotion; (1960) Off-the-Road Locomotion; (1969) Introduction to \
           Terrain-Vehicle Systems. University of Michigan Press.",
};

pub(crate) const CODUTO: Source =
    Source { number: 3, short: "Coduto 2001", text: "Coduto, D. P. (2001) Foundation Design: Principles and Practices." };

pub(crate) const DING_2015: Source = Source {
    number: 4,
    short: "Ding et al. 2015",
    text: "Ding, L., Deng, Z., Gao, H., Tao, J., Iagnemma, K. D., Liu, G. (2015) Interaction mechanics model for rigid \
           driving wheels of planetary rovers moving on sandy terrain with consideration of multiple physical effects. \
           Journal of Field Robotics 32, 827.",
};

pub(crate) const DING_2010: Source = Source {
    number: 5,
    short: "Ding et al. 2010",
    text: "Ding, L., and co-authors (2010), on slip–sinkage of the wheels of lunar rovers. Journal of Central South \
           University of Technology 17, 129; the abstract was read.",
};

pub(crate) const DING_2011: Source = Source {
    number: 6,
    short: "Ding et al. 2011",
    text: "Ding, L., Gao, H., Deng, Z., Nagatani, K., Yoshida, K. (2011) Experimental study and analysis on driving \
           wheels' performance for planetary exploration rovers moving in deformable soil. Journal of Terramechanics \
           48, 27.",
};

pub(crate) const DING_2009: Source = Source {
    number: 7,
    short: "Ding et al. 2009",
    text: "Ding, L., Yoshida, K., Nagatani, K., Gao, H., Deng, Z. (2009) Parameter identification for planetary soil \
           based on a decoupled analytical wheel-soil interaction terramechanics model. IEEE/RSJ International \
           Conference on Intelligent Robots and Systems.",
};

pub(crate) const IAGNEMMA: Source = Source {
    number: 8,
    short: "Iagnemma et al. 2004",
    text: "Iagnemma, K., Kang, S., Shibly, H., Dubowsky, S. (2004) Online terrain parameter estimation for wheeled \
           mobile robots with application to planetary rovers. IEEE Transactions on Robotics 20, 921.",
};

pub(crate) const JANOSI_HANAMOTO: Source = Source {
    number: 9,
    short: "Janosi & Hanamoto 1961",
    text: "Janosi, Z., Hanamoto, B. (1961) The analytical determination of drawbar pull as a function of slip for \
           tracked vehicles in deformable soils.",
};

pub(crate) const KOBAYASHI: Source = Source {
    number: 10,
    short: "Kobayashi et al. 2010",
    text: "Kobayashi, T., Fujiwara, Y., Yamakawa, J., Yasufuku, N., Omine, K. (2010) Mobility performance of a rigid \
           wheel in low gravity environments. Journal of Terramechanics 47, 261.",
};

pub(crate) const LINES: Source = Source {
    number: 11,
    short: "Lines 2021",
    text: "Lines, A. (2021) PhD thesis, Dartmouth College; read in its code, the repository austinlines/PhD.",
};

pub(crate) const LYASKO: Source = Source {
    number: 12,
    short: "Lyasko 2010",
    text: "Lyasko, M. (2010) Slip sinkage effect in soil–vehicle mechanics. Journal of Terramechanics 47, 21.",
};

pub(crate) const MEIRION_GRIFFITH_SPENKO: Source = Source {
    number: 13,
    short: "Meirion-Griffith & Spenko 2011",
    text: "Meirion-Griffith, G., Spenko, M. (2011) A modified pressure–sinkage model for small, rigid wheels on \
           deformable terrains. Journal of Terramechanics 48, 149.",
};

pub(crate) const PATEL: Source = Source {
    number: 14,
    short: "Patel, Scott & Ellery 2004",
    text: "Patel, N., Scott, G. P., Ellery, A. (2004) Application of Bekker theory for planetary exploration through \
           wheeled, tracked, and legged vehicle locomotion. AIAA Space 2004, 2109.",
};

pub(crate) const REECE: Source =
    Source { number: 15, short: "Reece 1965", text: "Reece, A. R. (1965) Principles of soil-vehicle mechanics." };

pub(crate) const SHIBLY: Source = Source {
    number: 16,
    short: "Shibly et al. 2005",
    text: "Shibly, H., Iagnemma, K., Dubowsky, S. (2005) An equivalent soil mechanics formulation for rigid wheels in \
           deformable terrain. Journal of Terramechanics 42, 1.",
};

pub(crate) const TERZAGHI: Source =
    Source { number: 17, short: "Terzaghi 1943", text: "Terzaghi, K. (1943) Theoretical Soil Mechanics. Wiley." };

pub(crate) const WONG_1980: Source = Source {
    number: 18,
    short: "Wong 1980",
    text: "Wong, J. Y. (1980) Data processing methodology in the characterization of the mechanical properties of \
           terrain. Journal of Terramechanics 17, 13.",
};

pub(crate) const WONG_BOOK: Source = Source {
    number: 19,
    short: "Wong, Theory of Ground Vehicles",
    text: "Wong, J. Y., Theory of Ground Vehicles, ch. 2. Wiley; quoted by public code and course material, not read in \
           the book.",
};

pub(crate) const WONG_2012: Source = Source {
    number: 20,
    short: "Wong 2012",
    text: "Wong, J. Y. (2012) Predicting the performances of rigid rover wheels on extraterrestrial surfaces based on \
           test results obtained on earth. Journal of Terramechanics 49, 49.",
};

pub(crate) const WONG_REECE_TOWED: Source = Source {
    number: 21,
    short: "Wong & Reece 1967, part II",
    text: "Wong, J. Y., Reece, A. R. (1967) Prediction of rigid wheel performance based on the analysis of soil-wheel \
           stresses, part II: performance of towed rigid wheels. Journal of Terramechanics 4(2).",
};

pub(crate) const WONG_REECE: Source = Source {
    number: 22,
    short: "Wong & Reece 1967",
    text: "Wong, J. Y., Reece, A. R. (1967) Prediction of rigid wheel performance based on the analysis of soil-wheel \
           stresses. Journal of Terramechanics 4(1), 81.",
};

pub(crate) const YOSHIDA: Source = Source {
    number: 23,
    short: "Yoshida et al. 2003",
    text: "Yoshida, K., Watanabe, T., Mizuno, N., Ishigami, G. (2003) Terramechanics-based analysis and traction \
           control of a lunar/planetary rover. Field and Service Robotics.",
};

pub(crate) const ISHIGAMI: Source = Source {
    number: 24,
    short: "Ishigami et al. 2005, 2007",
    text: "Ishigami, G., Miwa, A., Nagatani, K., Yoshida, K. (2007) Terramechanics-based model for steering maneuver of \
           planetary exploration rovers on loose soil. Journal of Field Robotics 24(3), 233; the wheel tests in JSME \
           Robotics and Mechatronics Conference 2005, 1A1-S-055.",
};

pub(crate) const PAVLOV_JOHNSON: Source = Source {
    number: 25,
    short: "Pavlov & Johnson 2024",
    text: "Pavlov, C., Johnson, A. M. (2024), on wheels at large slip angles, with measurements in the repository \
           3d-terramechanics of Carnegie Mellon University.",
};

pub(crate) const LI_ZHANG_GOLDMAN: Source = Source {
    number: 26,
    short: "Li, Zhang & Goldman 2013",
    text: "Li, C., Zhang, T., Goldman, D. I. (2013) A terradynamics of legged locomotion on granular media. Science 339, 1408; the \
           coefficients of its table S2 were read in public implementations.",
};

pub(crate) const AGARWAL_GOLDMAN_KAMRIN: Source = Source {
    number: 27,
    short: "Agarwal, Goldman & Kamrin 2023",
    text: "Agarwal, S., Goldman, D. I., Kamrin, K. (2023) Mechanistic framework for reduced-order models in soft materials: \
           application to three-dimensional granular intrusion. Proceedings of the National Academy of Sciences 120, e2214017120; \
           the polynomial of the stiffness is quoted, not read in the paper.",
};

/// Every work but the letter, by its number from 1.
pub const SOURCES: &[Source] = &[
    AKIN,
    BEKKER,
    CODUTO,
    DING_2015,
    DING_2010,
    DING_2011,
    DING_2009,
    IAGNEMMA,
    JANOSI_HANAMOTO,
    KOBAYASHI,
    LINES,
    LYASKO,
    MEIRION_GRIFFITH_SPENKO,
    PATEL,
    REECE,
    SHIBLY,
    TERZAGHI,
    WONG_1980,
    WONG_BOOK,
    WONG_2012,
    WONG_REECE_TOWED,
    WONG_REECE,
    YOSHIDA,
    ISHIGAMI,
    PAVLOV_JOHNSON,
    LI_ZHANG_GOLDMAN,
    AGARWAL_GOLDMAN_KAMRIN,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_works_are_numbered_from_one() {
        for (i, source) in SOURCES.iter().enumerate() {
            assert_eq!(usize::from(source.number), i + 1, "{}", source.short);
        }
    }
}
