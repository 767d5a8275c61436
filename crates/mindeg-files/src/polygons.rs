//! The polygons of a file.

use crate::error::FileError;
use crate::input::Input;
use crate::session::Session;
use glam::DVec2;
use mindeg_domain::{Domain, Projection, first_names};
use mindeg_outlines::{
    self as outlines, Division, DrawnInside, FillRule, Listed, OutlineError, OutlineFormat,
    Outlines, PeriodicCurve, Polygon, ProjectionChoice, Selection, SideKinds, with_kinds,
    with_periodic_sides,
};
use std::borrow::Cow;
use std::path::Path;

/// How the outlines of a file become polygons.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// The polygons that are taken, by a name or an index from 1; all without it.
    pub feature: Option<String>,
    /// The layer that is taken, and the property that names polygons.
    pub selection: Selection,
    /// Two corners of a box: the part of it that no polygon covers is taken in place of the polygons.
    pub sea_in: Option<[DVec2; 2]>,
    /// How degrees of longitude and latitude become metres; without it they are planar coordinates, which a note says.
    pub project: Option<ProjectionChoice>,
    /// Whether rings that touch or cross themselves are parted.
    pub repair: bool,
    /// How far vertices of holes that touch other rings move, to part them for a change of the boundary; not at all without it.
    pub parts_holes: Option<f64>,
    /// Whether each polygon is wanted by itself. If not, they are repaired together, as regions of one map whose borders stay
    /// shared.
    pub separate: bool,
    /// How near points become one in such a repair; by default as near as rounding parts them.
    pub snap: Option<f64>,
    /// The rule by which a repair counts points as inside; by default the format's.
    pub fill_rule: Option<FillRule>,
    /// How rings become sides and points.
    pub division: Division,
}

/// The polygons of a file, or those that were chosen.
#[derive(Debug)]
pub struct PolygonFile {
    /// The file, as messages name it.
    pub file: String,
    /// Its format.
    pub format: OutlineFormat,
    /// In the order of the file; indices count from 1 among all polygons of the file.
    pub polygons: Vec<Polygon>,
    /// Sentences for the user about parts that the reader left out or changed.
    pub notes: Vec<String>,
    /// Whether the coordinates are degrees of longitude and latitude, taken as planar.
    pub is_in_degrees: bool,
    inside: DrawnInside,
    periodic: Vec<PeriodicCurve>,
    kinds: SideKinds,
    name: Option<String>,
    projection: Option<Projection>,
    /// The projection, if the file has degrees.
    of_degrees: Option<Projection>,
    division: Division,
    is_repaired: bool,
    dashes: &'static str,
}

/// Whether planar coordinates look like degrees of longitude and latitude: all are within them, and one is larger than
/// those of small drawings.
///
/// ```
/// use mindeg_files::look_like_degrees;
///
/// let looks = |at: [f64; 2]| look_like_degrees([at.into()]);
/// assert!(looks([24.0, 37.5]) && looks([-3.0, -12.0]) && looks([350.0, 0.0]));
/// assert!(!looks([4.0, 3.0]) && !looks([24.0, 91.0]) && !looks([5e5, 60.0]));
/// ```
pub fn look_like_degrees(points: impl IntoIterator<Item = DVec2>) -> bool {
    const SMALL: f64 = 10.0;
    let greater = |most: DVec2, point: DVec2| most.max(point.abs());
    let most = points.into_iter().fold(DVec2::ZERO, greater);
    most.max_element() > SMALL && most.x <= 360.0 && most.y <= 90.0
}

impl PolygonFile {
    pub(crate) fn new(
        session: &Session,
        input: &Input<'_>,
        format: OutlineFormat,
        outlines: Result<Outlines, OutlineError>,
        options: &ReadOptions,
    ) -> Result<Self, FileError> {
        let wrong = |error: OutlineError| FileError::wrong(error.to_string());
        let mut outlines = outlines.map_err(wrong)?;
        let is_projected = options.project.is_some_and(|it| it != ProjectionChoice::None);
        if let Some(corners) = options.sea_in {
            if is_projected && outlines.is_in_degrees() && corners[1].x - corners[0].x >= 360.0 {
                return Err(FileError::wrong(
                    "the box of the sea goes all around the globe, and would have a seam: give one narrower than 360 degrees",
                ));
            }
            outlines = outlines.sea_in(corners).map_err(wrong)?;
        }
        if is_projected {
            outlines.join_at_antimeridian();
        }
        // The rest of a file of the world may have no place in the plane. Indices count the polygons that a repair makes.
        let wanted = options.feature.as_deref();
        let is_name = |wanted: &&str| {
            outlines.features.iter().any(|feature| feature.name.as_deref() == Some(*wanted))
        };
        let (mut chosen, mut repaired) = (None, None);
        if let Some(wanted) = wanted.filter(|wanted| !options.repair || is_name(wanted)) {
            chosen = Some(outlines.choose(wanted).map_err(wrong)?);
        } else if let Some(wanted) =
            wanted.filter(|_| is_projected && outlines.projection.is_none())
        {
            repaired = Some(outlines.choose_repaired(wanted, options.fill_rule).map_err(wrong)?);
        }
        let was_in_degrees = outlines.projection.is_none();
        let is_in_degrees = options.project.is_none() && outlines.is_in_degrees();
        if let Some(choice) = options.project {
            outlines = outlines.projected(choice).map_err(wrong)?;
        }
        let is_one_map = !options.separate && options.feature.is_none();
        if options.repair && is_one_map && outlines.features.len() > 1 {
            outlines =
                outlines.repaired_together(options.fill_rule, options.snap).map_err(wrong)?;
        } else if options.repair {
            outlines = outlines.repaired(options.fill_rule).map_err(wrong)?;
        } else if let Some(polygons) = outlines.across_antimeridian() {
            let dashes = session.dashes();
            outlines.notes.push(format!(
                "{polygons} with edges across the antimeridian, which run back around the world in the plane; \
                 {dashes}repair cuts them there"
            ));
        }
        if let Some(within) = options.parts_holes {
            outlines = outlines.with_parted_holes(within);
        }
        let Outlines { features, mut inside, periodic, kinds, mut notes, projection, .. } =
            outlines;
        let rings = features.iter().flat_map(|feature| &feature.rings);
        let starts = rings.flat_map(|ring| ring.pieces.iter().map(|piece| piece.start));
        if is_in_degrees && look_like_degrees(starts) {
            notes.push(format!(
                "its coordinates look like degrees of longitude and latitude, and are taken as planar; {}project auto makes \
                 metres of them",
                session.dashes()
            ));
        }
        let mut polygons = match (chosen, &repaired) {
            (_, Some((polygon, before))) => {
                let made = features.into_iter().nth(*before);
                made.map(|feature| Polygon { feature, ..polygon.clone() }).into_iter().collect()
            }
            (Some(polygons), _) if !options.repair => {
                let pairs = polygons.into_iter().zip(features);
                pairs.map(|(polygon, feature)| Polygon { feature, ..polygon }).collect()
            }
            _ => outlines::labelled(features),
        };
        // A file of one shape without a name is called after that shape.
        if let ([polygon], Some(stem)) = (&mut polygons[..], input.path().and_then(plain_stem))
            && polygon.label.is_empty()
        {
            stem.clone_into(&mut polygon.label);
        }
        if let Some(wanted) = wanted.filter(|_| options.repair) {
            if repaired.is_none() {
                polygons = outlines::chosen(polygons, wanted).map_err(wrong)?;
            }
            inside.keep_within(polygons.iter().map(|polygon| &polygon.feature));
        }
        Ok(Self {
            file: input.name(),
            format,
            polygons,
            notes,
            inside,
            periodic,
            kinds,
            name: options
                .selection
                .layer
                .clone()
                .or_else(|| input.path().and_then(plain_stem).map(str::to_owned)),
            is_in_degrees,
            projection,
            of_degrees: projection.filter(|_| was_in_degrees),
            division: options.division.clone(),
            is_repaired: options.repair,
            dashes: session.dashes(),
        })
    }

    /// The name of all of them together: the layer, or the file's name without its extension.
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The domain of one of them.
    ///
    /// # Errors
    ///
    /// The reason why it is not a domain, under its name.
    pub fn domain(&self, polygon: &Polygon) -> Result<Domain, FileError> {
        let mut inside = Cow::Borrowed(&self.inside);
        if self.polygons.len() > 1 && !inside.is_empty() {
            inside.to_mut().keep_within([&polygon.feature]);
        }
        let is_plain = inside.is_empty() && polygon.feature.max_area.is_none();
        let domain = match is_plain {
            true => polygon.domain(&self.division),
            false => polygon.map(&inside, &self.division),
        };
        let domain = domain
            .and_then(|domain| with_periodic_sides(domain, &self.periodic))
            .and_then(|domain| with_kinds(domain, &self.kinds))
            .map(|domain| domain.with_projection(self.projection));
        let domain = domain.map_err(|error| {
            let error = self.as_in_file(error);
            let said = error.to_string();
            let is_well = || polygon.domain(&Division::default()).is_ok();
            FileError::wrong(self.with_hint(said, error.is_touch, is_well)).of(&polygon.name())
        })?;
        if self.polygons.len() == 1 {
            self.check_sizes(std::slice::from_ref(&domain))?;
        }
        Ok(domain)
    }

    /// Refuses a size of sides and lines whose name there is not.
    fn check_sizes(&self, domains: &[Domain]) -> Result<(), FileError> {
        if self.division.sizes.is_empty() {
            return Ok(());
        }
        let names = Domain::names_of(domains);
        match self.division.sizes.keys().find(|name| names.binary_search(name).is_err()) {
            Some(name) => Err(FileError::wrong(format!(
                "no side or line is called {name:?}; there are {}",
                first_names(&names)
            ))),
            None => Ok(()),
        }
    }

    /// The maps of several polygons: those that share edges are regions of one domain. A single polygon is its domain.
    /// The notes are sentences for the user.
    ///
    /// # Errors
    ///
    /// The reason why there is no map: polygons that overlap or cross, with both names and the place.
    pub fn maps(&self) -> Result<(Vec<Domain>, Vec<String>), FileError> {
        if let [polygon] = &self.polygons[..] {
            let domain = self.domain(polygon).map_err(|error| error.of(&self.file))?;
            return Ok((vec![domain], Vec::new()));
        }
        let maps = outlines::maps(&self.polygons, &self.inside, &self.division, self.is_repaired);
        let maps = maps.and_then(|(domains, notes)| {
            let domains = domains.into_iter().map(|domain| {
                let domain = with_kinds(with_periodic_sides(domain, &self.periodic)?, &self.kinds)?;
                Ok::<Domain, OutlineError>(domain.with_projection(self.projection))
            });
            let mut domains: Vec<Domain> = domains.collect::<Result<_, _>>()?;
            // A map in one part is that of the file.
            if let ([map], Some(name)) = (&mut domains[..], self.name())
                && map.name().is_none()
            {
                *map = map.clone().named(name)?;
            }
            Ok((domains, notes))
        });
        let (domains, notes) = maps.map_err(|error| {
            let error = self.as_in_file(error);
            let said = error.to_string();
            let is_well = || {
                let whole = Division::default();
                outlines::maps(&self.polygons, &self.inside, &whole, self.is_repaired).is_ok()
            };
            FileError::wrong(self.with_hint(said, error.is_touch, is_well)).of(&self.file)
        })?;
        self.check_sizes(&domains).map_err(|error| error.of(&self.file))?;
        Ok((domains, notes))
    }

    /// An error with its places as the file has them.
    fn as_in_file(&self, error: OutlineError) -> OutlineError {
        match &self.of_degrees {
            Some(projection) => error.in_degrees(projection),
            None => error,
        }
    }

    /// What is wrong, with what to do. Whether the outline itself is well, and edges of the size asked for are the cause, is
    /// worked out where it matters: no repair of the outline helps then.
    fn with_hint(&self, mut said: String, is_touch: bool, is_well: impl Fn() -> bool) -> String {
        let dashes = self.dashes;
        let is_cut = is_touch && self.division.size.is_some() && said.contains(" cross near ");
        if is_touch && !self.is_repaired && !(is_cut && is_well()) {
            said += &format!("; {dashes}repair mends such places, and says what it changes");
        }
        if is_cut {
            said += &format!(
                "; edges of a smaller size cut off less, and {dashes}condition keeps edges of this size apart"
            );
        }
        said
    }

    /// The only domain: that of a single polygon, or the map of several that share edges.
    ///
    /// # Errors
    ///
    /// The reason why it is not a domain, or that the polygons of the file do not hang together.
    pub fn only(&self) -> Result<Domain, FileError> {
        match &self.polygons[..] {
            [polygon] => self.domain(polygon).map_err(|error| error.of(&self.file)),
            [] => Err(FileError::wrong(format!(
                "{} has no polygon with an area; draw it in another program to see what is wrong",
                self.file
            ))),
            polygons => {
                let choose = format!(
                    "choose one with {}feature, by its name or index: {}",
                    self.dashes,
                    Listed(polygons)
                );
                match self.maps().map(|found| found.0).as_deref() {
                    Ok([map]) => Ok(map.clone()),
                    Ok(_) => Err(FileError::wrong(format!(
                        "{} has {} polygons; {choose}",
                        self.file,
                        polygons.len(),
                    ))),
                    Err(error) => Err(FileError::wrong(format!("{error}; or {choose}"))),
                }
            }
        }
    }
}

/// The name of a file without its extension, if it can be the name of a domain in every format.
fn plain_stem(path: &Path) -> Option<&str> {
    let is_plain = |stem: &&str| stem.chars().all(|c| c.is_alphanumeric() || "-_. ".contains(c));
    path.extension().and(path.file_stem())?.to_str().filter(is_plain)
}
