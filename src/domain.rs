//! From arguments to a validated domain.

pub(crate) mod describe;

use crate::args::{
    Counts, CountsArguments, DomainArguments, DomainOptions, Length, OutlineOptions,
};
use crate::bar::Bar;
use crate::failure::Failure;
use crate::interrupt::SESSION;
use crate::terminal::say;
use crate::unused::Taken;
use mindeg::{Domain, Intervals, Model, Outline, Rectangle, Side, TriMesh};
use mindeg_answers::names::{part_name, shown};
use mindeg_answers::numbers;
use mindeg_files::{
    Content, Division, Input, PolygonFile, ProjectionChoice, ReadOptions, Selection, Wanted,
};
use std::borrow::Cow;
use std::path::Path;

/// The subject that the arguments describe.
pub(crate) enum Subject {
    Domain(Box<Domain>),
    /// The polygons of a file, not in JSON.
    Polygons(Box<PolygonFile>),
    Model(Box<Model>),
    Mesh(Box<TriMesh>),
}

/// No length in degrees is greater.
const ROUND_THE_WORLD: f64 = 360.0;

impl Subject {
    /// Refuses lengths in metres where coordinates are degrees, and lengths that no degrees are.
    pub(crate) fn refuse_degrees<'a>(
        &self,
        lengths: impl IntoIterator<Item = (&'a str, Option<Length>)>,
    ) -> Result<(), Failure> {
        let Self::Polygons(polygons) = self else { return Ok(()) };
        if !polygons.is_in_degrees {
            return Ok(());
        }
        let file = &polygons.file;
        for (option, length) in lengths {
            let Some(length) = length else { continue };
            if !length.is_metric && length.value > ROUND_THE_WORLD {
                return Err(Failure::Input(format!(
                    "{option} is {} degrees, as the coordinates of {file} are: add --project auto, and lengths are metres; or \
                     --project none, if the coordinates are metres",
                    length.value
                )));
            }
            if length.is_metric {
                return Err(Failure::Input(format!(
                    "{option} is in metres, and the coordinates of {file} look like degrees: add --project auto; or \
                     --project none, if they are metres"
                )));
            }
        }
        Ok(())
    }

    /// The only domain, or the reason why there are several.
    pub(crate) fn only(self) -> Result<Domain, Failure> {
        match self {
            Self::Domain(domain) => Ok(*domain),
            Self::Polygons(polygons) => Ok(polygons.only()?),
            Self::Model(_) | Self::Mesh(_) => unreachable!("opened as a domain"),
        }
    }

    /// The only domain, or those of polygons that do not all hang together.
    pub(crate) fn parts(self) -> Result<Parts, Failure> {
        match self {
            Self::Polygons(polygons) if polygons.polygons.len() > 1 => {
                Parts::of(&polygons, "choose one with --feature")
            }
            one => Ok(Parts { name: None, domains: vec![one.only()?] }),
        }
    }
}

/// Domains beside each other that are meshed as one, such as islands; mostly one domain.
pub(crate) struct Parts {
    /// The name of all together, if there are several.
    pub(crate) name: Option<String>,
    pub(crate) domains: Vec<Domain>,
}

impl Parts {
    /// The parts of polygons that are the regions of a map; `way_out` says what to do where they cannot be.
    pub(crate) fn of(polygons: &PolygonFile, way_out: &str) -> Result<Self, Failure> {
        let (domains, notes) =
            polygons.maps().map_err(|error| Failure::Input(format!("{error}; or {way_out}")))?;
        notes.iter().for_each(|note| say(&format!("{}: {note}", polygons.file)));
        Ok(Self { name: polygons.name().map(str::to_owned), domains })
    }

    /// The first part under the name of all.
    pub(crate) fn whole(&self) -> Domain {
        let first = &self.domains[0];
        let named = self.name.as_deref().and_then(|name| first.clone().named(name).ok());
        named.unwrap_or_else(|| first.clone())
    }

    /// The name of all within a sentence.
    pub(crate) fn name_in_text(&self) -> String {
        match (&self.name, &self.domains[..]) {
            (None, [domain]) => name_in_text(domain).into_owned(),
            (name, _) => shown(name.as_deref().unwrap_or("the map")).into_owned(),
        }
    }

    /// The failure of a part, which is named if there are several.
    pub(crate) fn failure(&self, (index, failure): (usize, Failure)) -> Failure {
        match &self.domains[..] {
            [_] => failure,
            domains => failure.of(&part_name(index, &domains[index])),
        }
    }
}

/// The name of a domain without a name.
pub(crate) const UNNAMED: &str = "domain";

/// The name of a domain at the start of a line.
pub(crate) fn name(domain: &Domain) -> Cow<'_, str> {
    shown(domain.name().unwrap_or(UNNAMED))
}

/// The name of a domain within a sentence.
pub(crate) fn name_in_text(domain: &Domain) -> Cow<'_, str> {
    shown(domain.name().unwrap_or("the domain"))
}

/// The subject of a question about degrees.
pub(crate) enum Counted {
    /// Interval counts as typed.
    Counts(Vec<u64>),
    /// The subject that a file or options describe.
    Subject(Subject),
}

/// The interval counts as typed, or the domain that the arguments describe.
pub(crate) fn counted(arguments: &CountsArguments, wanted: Wanted) -> Result<Counted, Failure> {
    let CountsArguments { counts, options } = arguments;
    let subject = match counts {
        Some(Counts::Given(_)) if options.divides() => {
            return Err(Failure::input(
                "--intervals, --size and --spacing divide the sides of a domain; the counts \
                           are given already",
            ));
        }
        Some(Counts::Given(counts)) => {
            Taken::Counts.refuse_unused("")?;
            return Ok(Counted::Counts(counts.clone()));
        }
        Some(Counts::Domain(path)) => in_file(path, options, wanted, &Bar::new(true))?,
        // The counts of sides that nothing else describes.
        None if options.are_counts() => {
            Taken::Counts.refuse_unused("")?;
            let counts = options.intervals.iter().flat_map(|counts| counts.0.iter().copied());
            return Ok(Counted::Counts(counts.collect()));
        }
        None => Subject::Domain(Box::new(from_options(options)?)),
    };
    Ok(Counted::Subject(subject))
}

/// The domain in a file, or those of its polygons that do not all hang together; options override the file's settings of sides.
pub(crate) fn parts(path: &Path, options: &DomainOptions) -> Result<Parts, Failure> {
    in_file(path, options, Wanted::Domain, &Bar::new(true))?.parts()
}

/// The subject that the arguments describe: it is or becomes a domain unless `wanted` allows more.
pub(crate) fn subject(
    arguments: &DomainArguments,
    wanted: Wanted,
    bar: &Bar,
) -> Result<Subject, Failure> {
    match &arguments.file {
        None => from_options(&arguments.options).map(|domain| Subject::Domain(Box::new(domain))),
        Some(path) => in_file(path, &arguments.options, wanted, bar),
    }
}

/// The content of a file; options override its settings of a domain's sides.
pub(crate) fn in_file(
    path: &Path,
    options: &DomainOptions,
    wanted: Wanted,
    bar: &Bar,
) -> Result<Subject, Failure> {
    let DomainOptions { intervals, size, spacing, outline, .. } = options;
    let subject = opened(path, outline, size.map(|size| size.value), wanted, bar)?;
    subject.refuse_degrees([("--size", *size)])?;
    match subject {
        Subject::Domain(domain) if options.divides() => {
            let sides = overridden(domain.sides().to_vec(), options)?;
            let domain = domain.with_sides(sides).map_err(Failure::input)?;
            Ok(Subject::Domain(Box::new(periodic(domain, options)?)))
        }
        Subject::Domain(domain) => Ok(Subject::Domain(Box::new(periodic(*domain, options)?))),
        Subject::Polygons(polygons) if !options.periodic.is_empty() => match &polygons.polygons[..]
        {
            [_] if intervals.is_none() && spacing.is_none() => {
                Ok(Subject::Domain(Box::new(periodic(polygons.only()?, options)?)))
            }
            _ => Err(Failure::input(
                "--periodic is for one domain, and without --intervals and --spacing in a file of polygons; choose one with \
                 --feature",
            )),
        },
        Subject::Polygons(_) if intervals.is_some() || spacing.is_some() => Err(Failure::input(
            "--intervals and --spacing divide the sides of a domain in JSON; give \
                           --size here, or write the domain with mindeg domain and edit it",
        )),
        subject => Ok(subject),
    }
}

/// The content of a file, or of standard input if the path is `-`.
pub(crate) fn opened(
    path: &Path,
    options: &OutlineOptions,
    size: Option<f64>,
    wanted: Wanted,
    bar: &Bar,
) -> Result<Subject, Failure> {
    let input = Input::of(path);
    let name = input.name();
    let sizes = options.size_of.iter().map(|(name, size)| (name.clone(), size.value)).collect();
    let division = Division { corner_angle: options.corner_angle, size, sizes };
    let OutlineOptions { sea_in, project, repair, separate, snap, fill_rule, .. } = *options;
    let selection = Selection { layer: options.layer.clone(), name_by: options.name_by.clone() };
    let (repair, parts_holes) = (repair || options.mends.is_some(), options.mends);
    let feature = options.feature.clone();
    let read = ReadOptions {
        feature,
        selection,
        sea_in: sea_in.map(|[x, y, right, top]| [[x, y].into(), [right, top].into()]),
        project,
        repair,
        parts_holes,
        separate,
        snap: snap.map(|length| length.value),
        fill_rule,
        division,
    };
    let bad = |error: &dyn ToString| Failure::Input(format!("{name}: {}", error.to_string()));
    Ok(match bar.work(|progress| SESSION.open(&input, wanted, &read, progress))? {
        Content::Domain(text) => {
            Taken::Domain.refuse_unused(&name)?;
            let domain = match repair {
                true => Domain::from_json_noded(&text),
                false => Domain::from_json(&text),
            };
            let domain = domain.map_err(|error| {
                let is_mended = !repair && Domain::from_json_noded(&text).is_ok();
                let hint = "; --repair gives lines that cross a point there";
                let message = format!("{name}: {error}{}", if is_mended { hint } else { "" });
                Failure::Domain { message, error: Box::new(error) }
            })?;
            let projection = domain.projection().copied();
            let domain = domain
                .with_projection(projection.filter(|_| project != Some(ProjectionChoice::None)));
            Subject::Domain(Box::new(SESSION.with_sizes(domain, &input)?))
        }
        Content::Model(text) => {
            Taken::Model.refuse_unused(&name)?;
            Subject::Model(Box::new(Model::from_json(&text).map_err(|error| bad(&error))?))
        }
        Content::Polygons(polygons) => {
            Taken::Polygons.refuse_unused(&name)?;
            polygons.notes.iter().for_each(|note| say(&format!("{name}: {note}")));
            let subject = Subject::Polygons(polygons);
            let lengths = options.size_of.iter().map(|(_, size)| ("--size-of", Some(*size)));
            subject.refuse_degrees(lengths.chain([("--snap", snap)]))?;
            subject
        }
        Content::Mesh(mesh) => {
            // A mesh that is only shown is no model.
            if wanted == Wanted::Model {
                Taken::FromMesh.refuse_unused(&name)?;
            }
            Subject::Mesh(mesh)
        }
    })
}

/// The domain that options describe without a file.
pub(crate) fn from_options(options: &DomainOptions) -> Result<Domain, Failure> {
    let DomainOptions { rectangle, corners, intervals, size, .. } = options;
    let (outline, side_count) = match (rectangle, corners) {
        (Some(size), _) => (Outline::Rectangle(Rectangle::new(size.width, size.height)), 4),
        (None, Some(corners)) => {
            let corners: Vec<_> = corners.0.iter().copied().map(Into::into).collect();
            let count = corners.len();
            (Outline::Polygon(corners), count)
        }
        (None, None) => {
            return Err(Failure::input(
                "no domain: name its file, or - for standard input, or give --rectangle or --corners",
            ));
        }
    };
    Taken::Corners.refuse_unused("")?;
    if intervals.is_none() && size.is_none() {
        return Err(Failure::input("how many intervals? give --intervals a,b,… or --size S"));
    }
    let sides = overridden(vec![Side::count(1); side_count], options)?;
    periodic(Domain::new(outline, sides).map_err(Failure::input)?, options)
}

/// The same domain with the periodic sides that the options give.
fn periodic(domain: Domain, options: &DomainOptions) -> Result<Domain, Failure> {
    if options.periodic.is_empty() {
        return Ok(domain);
    }
    domain
        .with_periodic(&options.periodic)
        .map_err(|error| Failure::Input(format!("--periodic: {error}")))
}

/// Applies the command-line options to the sides.
fn overridden(mut sides: Vec<Side>, options: &DomainOptions) -> Result<Vec<Side>, Failure> {
    if let Some(counts) = &options.intervals {
        if counts.0.len() != sides.len() {
            return Err(Failure::Input(format!(
                "--intervals gives {} for {}; give one for each side, counter-clockwise",
                numbers::counted(counts.0.len() as u64, "count"),
                numbers::counted(sides.len() as u64, "side")
            )));
        }
        for (side, &count) in sides.iter_mut().zip(&counts.0) {
            side.intervals = Intervals::Count(count);
        }
    }
    for side in &mut sides {
        if let Some(size) = options.size {
            side.intervals = Intervals::Size(size.value);
        }
        if let Some(spacing) = &options.spacing {
            side.spacing = spacing.clone();
        }
    }
    Ok(sides)
}
