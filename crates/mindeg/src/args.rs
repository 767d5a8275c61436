//! The arguments as they are typed.

use clap::{Args, Parser, Subcommand};

const EXIT_CODES: &str = "\
Exit codes:
  0  success (also when the reader of standard output stops early)
  1  something could not be read or written
  2  bad input: wrong usage, a domain that is no convex polygon, counts out of range";

/// Mesh a rectangle or convex polygon from its boundary points alone, with the least possible
/// maximum degree.
#[derive(Debug, Parser)]
#[command(version, after_help = EXIT_CODES, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Degree(DegreeArguments),
}

/// Tell the least possible maximum degree from interval counts alone, and why it cannot be less
///
/// The degree of a vertex is the number of edges at it, boundary edges included (its valence).
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct DegreeArguments {
    /// The intervals of each side, counter-clockwise, such as 3,3,2,2
    #[arg(value_name = "INTERVALS")]
    pub(crate) intervals: IntervalCounts,

    /// Print JSON: intervals, vertices, triangles, interior_edges, max_degree, certificate
    #[arg(long)]
    pub(crate) json: bool,
}

/// A list of interval counts, one for each side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct IntervalCounts(pub(crate) Vec<u64>);

impl std::str::FromStr for IntervalCounts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = |(side, count): (usize, &str)| {
            count.trim().parse().map_err(|_| {
                format!(
                    "side {}: {count:?} is not a whole number of intervals; give one count for \
                     each side, such as 3,3,2,2",
                    side + 1
                )
            })
        };
        text.split(',').enumerate().map(parse).collect::<Result<_, _>>().map(Self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_well_formed() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn interval_counts_are_read_side_by_side() {
        assert_eq!("3, 3,2,2".parse(), Ok(IntervalCounts(vec![3, 3, 2, 2])));
        for (text, side) in
            [("", "side 1"), ("3,,2", "side 2"), ("3,-1,2", "side 2"), ("1,2,2.5", "side 3")]
        {
            let error = text.parse::<IntervalCounts>().unwrap_err();
            assert!(error.starts_with(side), "{text:?}: {error}");
        }
    }
}
