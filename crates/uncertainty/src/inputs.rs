//! All uncertain inputs of a model together.

use crate::correlation::Correlation;
use crate::error::{CorrelationError, DesignError};
use crate::joint::Joint;
use crate::marginal::{Marginal, NEAREST_TO_END};
use crate::normal;

/// The most sources of uncertainty. A design takes two dimensions of the sequence for each.
pub const MOST_SOURCES: usize = 24;

/// What makes one or several numbers uncertain.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// One number with a distribution.
    One(Marginal),
    /// Several numbers with joint samples.
    Joint(Joint),
}

impl Source {
    /// How many numbers it makes.
    pub fn width(&self) -> usize {
        match self {
            Self::One(_) => 1,
            Self::Joint(joint) => joint.width(),
        }
    }
}

/// All uncertain inputs of a model.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    sources: Vec<Source>,
    correlation: Option<Correlation>,
    groups: Vec<Vec<usize>>,
}

impl Inputs {
    /// Independent sources.
    ///
    /// # Errors
    /// No source, or more than [`MOST_SOURCES`].
    pub fn new(sources: Vec<Source>) -> Result<Self, DesignError> {
        if !(1..=MOST_SOURCES).contains(&sources.len()) {
            return Err(DesignError::Sources { count: sources.len() });
        }
        let groups = (0..sources.len()).map(|source| vec![source]).collect();
        Ok(Self { sources, correlation: None, groups })
    }

    /// The same inputs, correlated.
    ///
    /// # Errors
    /// A matrix of another size than the number of sources, or that correlates joint samples.
    pub fn correlated(self, correlation: Correlation) -> Result<Self, CorrelationError> {
        let count = self.sources.len();
        if correlation.len() != count {
            return Err(CorrelationError::Size { expected: count, found: correlation.len(), row: None });
        }
        let of_joint = |source: &usize| matches!(self.sources[*source], Source::Joint(_)) && correlation.is_of(*source);
        if let Some(row) = (0..count).find(of_joint) {
            return Err(CorrelationError::OfJoint { row });
        }
        let groups = groups(count, &correlation);
        Ok(Self { correlation: Some(correlation), groups, ..self })
    }

    /// The sources.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// The sources in groups that are independent of one another. A source that is correlated with none is a group of its own.
    pub fn groups(&self) -> &[Vec<usize>] {
        &self.groups
    }

    /// How many numbers they make.
    pub fn width(&self) -> usize {
        self.sources.iter().map(Source::width).sum()
    }

    /// The numbers for a point of the unit cube, in the order of the sources.
    pub(crate) fn values(&self, point: &[f64]) -> Vec<f64> {
        let scores: Vec<f64> = match &self.correlation {
            Some(_) => point.iter().map(|p| normal::quantile(*p)).collect(),
            None => Vec::new(),
        };
        let mut values = Vec::with_capacity(self.width());
        for (i, source) in self.sources.iter().enumerate() {
            match source {
                Source::One(marginal) => values.push(match &self.correlation {
                    Some(correlation) if correlation.is_of(i) => {
                        let share = normal::share_below(correlation.score(i, &scores));
                        marginal.quantile(share.clamp(NEAREST_TO_END, 1.0 - NEAREST_TO_END))
                    }
                    _ => marginal.quantile(point[i]),
                }),
                Source::Joint(joint) => values.extend(joint.row(point[i])),
            }
        }
        values
    }
}

/// Which inputs hang together by correlation, directly or through others.
fn groups(count: usize, correlation: &Correlation) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for input in 0..count {
        let is_joined = |group: &Vec<usize>| group.iter().any(|member| correlation.joins(input, *member));
        let (joined, apart): (Vec<_>, Vec<_>) = groups.into_iter().partition(is_joined);
        let mut group: Vec<usize> = joined.into_iter().flatten().chain([input]).collect();
        group.sort_unstable();
        groups = apart;
        groups.push(group);
    }
    groups.sort();
    groups
}
