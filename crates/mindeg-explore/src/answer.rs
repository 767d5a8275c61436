//! From the body of a request to the lines of its answer, the fast ones first.

use std::time::{Duration, Instant};

use mindeg::exact::trade_off;
use mindeg::interior::InteriorError;
use mindeg::{BoundaryMesh, Domain, Goal, TriMesh, is_by_formula};
use mindeg_answers::advice::{Advice, AdviceAnswer, AdvisedMesh, NoPoints, Purpose};
use mindeg_answers::degree::DegreeReport;
use mindeg_answers::on_edges::is_poor;
use mindeg_answers::trade_off::TradeOffAnswer;
use mindeg_mesh::{Cancelled, Progress};

use crate::api::{AnswerLine, CurveShown, DegreeShown, Part, Request, View};
use crate::changes;
use crate::command::{KnownFiles, command};
use crate::mesh::{Made, coarser, no_interior};
use crate::shown::{self, Figure};
use crate::terms::without_options;

/// The most boundary vertices of a domain.
pub const MAX_VERTICES: u32 = 100_000;

type Out<'a> = &'a mut dyn FnMut(&AnswerLine);

/// Answers a request: its lines go to `out` one by one, the last of them [`AnswerLine::Done`], unless the request
/// or its domain is refused.
///
/// # Errors
///
/// [`Cancelled`], if the `progress` callback breaks.
///
/// # Example
///
/// ```
/// use mindeg_explore::{KnownFiles, AnswerLine, answer};
/// use mindeg_mesh::Progress;
///
/// let body = br#"{"domain": {"rectangle": {"width": 4, "height": 3}, "size": 0.5}, "show": ["wanted"]}"#;
/// let mut degree = None;
/// answer(body, &KnownFiles::default(), Progress::NONE, &mut |line| {
///     if let AnswerLine::Mesh(mesh) = line {
///         degree = Some(mesh.max_degree);
///     }
/// })?;
/// assert_eq!(degree, Some(4));
/// # Ok::<(), mindeg_mesh::Cancelled>(())
/// ```
pub fn answer(
    body: &[u8],
    known: &KnownFiles,
    progress: Progress<'_>,
    out: Out<'_>,
) -> Result<(), Cancelled> {
    let start = Instant::now();
    let (request, domain) = match understood(body) {
        Ok(understood) => understood,
        Err((message, path)) => {
            out(&AnswerLine::Refused { part: None, message, path, coarser: None });
            return Ok(());
        }
    };
    out(&AnswerLine::Domain(shown::domain(&domain)));
    let (made, is_poor, no_interior) = ([None; 3], false, None);
    Answering {
        request: &request,
        domain: &domain,
        known,
        progress,
        out,
        made,
        is_poor,
        no_interior,
    }
    .all()?;
    out(&AnswerLine::Done { milliseconds: 1e3 * start.elapsed().as_secs_f64() });
    Ok(())
}

/// The request in a body, and its domain.
///
/// # Errors
///
/// The request and its domain; or the fault, in a sentence, and the key of the domain where it is.
pub(crate) fn understood(body: &[u8]) -> Result<(Request, Domain), (String, Option<String>)> {
    let request: Request = serde_json::from_slice(body)
        .map_err(|error| format!("the request is not what the page sends: {error}"))
        .and_then(|request: Request| request.checked())
        .map_err(|message| (without_options(&message), None))?;
    let domain = Domain::from_json_up_to(request.domain.get(), MAX_VERTICES)
        .map_err(|error| (without_options(&error.without_position()), Some(error.path)))?;
    Ok((request, domain))
}

/// The line to send when the time of an answer is over.
pub(crate) fn late(limit: Duration) -> AnswerLine {
    let seconds = limit.as_secs();
    refused(
        None,
        format!("it took more than {seconds} s and was ended; the command line has no limit"),
    )
}

pub(crate) fn refused(part: Option<Part>, message: String) -> AnswerLine {
    AnswerLine::Refused { part, message: without_options(&message), path: None, coarser: None }
}

/// Why there is no mesh with points inside.
fn refused_inside(domain: &Domain, error: &InteriorError) -> AnswerLine {
    AnswerLine::Refused {
        part: Some(Part::Interior),
        message: without_options(&no_interior(error)),
        path: None,
        coarser: coarser(domain, error),
    }
}

/// An answer in the making.
struct Answering<'a> {
    request: &'a Request,
    domain: &'a Domain,
    known: &'a KnownFiles,
    progress: Progress<'a>,
    out: Out<'a>,
    /// The figures of the meshes for [`Purpose::ALL`] that were made.
    made: [Option<AdvisedMesh>; 3],
    /// Whether that with points inside shows a poor boundary.
    is_poor: bool,
    /// Why there is no mesh with points inside.
    no_interior: Option<NoPoints>,
}

impl Answering<'_> {
    fn all(mut self) -> Result<(), Cancelled> {
        if self.shows(Part::Command) {
            let text = command(self.request, self.domain, self.known);
            (self.out)(&AnswerLine::Command { text });
        }
        let is_enough = self.soon();
        if self.request.drafts_only {
            return self.drafts(is_enough);
        }
        // The view that a reader looks at comes before all searches.
        let is_first = self.request.view == View::Interior;
        if is_first && self.shows(Part::Interior) {
            self.interior()?;
        }
        if !is_enough {
            self.first_meshes()?;
        }
        let delaunay = if self.shows(Part::Delaunay) || self.shows(Part::Curve) {
            self.mesh(Part::Delaunay, View::Delaunay)?
        } else {
            None
        };
        if self.shows(Part::Wanted) && self.request.goal != Goal::LeastDegree {
            self.mesh(Part::Wanted, View::Wanted)?;
        }
        if !is_first && self.shows(Part::Interior) {
            self.interior()?;
        }
        if self.shows(Part::Advice) {
            self.advice()?;
        }
        if self.shows(Part::Degree) {
            match DegreeReport::of(self.domain, self.progress) {
                Ok(report) => {
                    let words = without_options(&report.words);
                    (self.out)(&AnswerLine::Degree(DegreeShown { report, words }));
                }
                Err(error) => self.refuse(Part::Degree, error.to_string())?,
            }
        }
        if self.shows(Part::Curve) {
            match trade_off(self.domain, self.progress) {
                Ok(found) => {
                    let delaunay_max_degree = delaunay.map(|figure| figure.max_degree());
                    let answer = TradeOffAnswer::of(&found);
                    (self.out)(&AnswerLine::Curve(CurveShown {
                        open_question: answer.open_question(),
                        delaunay_max_degree,
                        answer,
                    }));
                }
                Err(error) => self.refuse(Part::Curve, error.to_string())?,
            }
        }
        self.changes()
    }

    /// The meshes that need no search, if those of [`Self::soon`] are not enough.
    fn drafts(&mut self, is_enough: bool) -> Result<(), Cancelled> {
        if self.shows(Part::Interior) {
            let draft = Made::draft(self.domain, self.progress);
            self.unless_cancelled()?;
            match draft {
                Ok(draft) => self.show_draft(&draft, "The mesh follows when the corner rests."),
                Err(error) => (self.out)(&refused_inside(self.domain, &error)),
            }
        }
        if !is_enough && is_by_formula(self.domain) {
            self.first_meshes()?;
        }
        if self.shows(Part::Delaunay) {
            self.mesh(Part::Delaunay, View::Delaunay)?;
        }
        Ok(())
    }

    /// The mesh with points inside, and before it its draft: a picture that follows a corner must not wait.
    fn interior(&mut self) -> Result<(), Cancelled> {
        let (domain, progress) = (self.domain, self.progress);
        let made = if self.shows(Part::Interior) {
            let mut show = |draft: TriMesh| self.show_draft(&draft, "A better mesh is looked for.");
            Made::interior(domain, Some(&mut show), progress)
        } else {
            Made::interior(domain, None, progress)
        };
        self.unless_cancelled()?;
        match made {
            Ok(made) => {
                self.note(&made);
                if self.shows(Part::Interior) {
                    let figure = Figure::made(domain, &made);
                    let shown = figure.shown(View::Interior, true, self.request);
                    (self.out)(&AnswerLine::Mesh(Box::new(shown)));
                }
            }
            Err(error) => {
                if self.shows(Part::Interior) {
                    (self.out)(&refused_inside(domain, &error));
                }
                self.no_interior = Some(NoPoints::from(&error));
            }
        }
        Ok(())
    }

    /// Shows a mesh with points inside until another one comes.
    fn show_draft(&mut self, draft: &TriMesh, what_follows: &str) {
        let figure = Figure::draft(self.domain, draft, what_follows);
        let shown = figure.shown(View::Interior, false, self.request);
        (self.out)(&AnswerLine::Mesh(Box::new(shown)));
    }

    /// The advice, for which the meshes that are not there yet are made.
    fn advice(&mut self) -> Result<(), Cancelled> {
        for (place, purpose) in Purpose::ALL.into_iter().enumerate() {
            if self.made[place].is_some() {
                continue;
            }
            let Some(goal) = purpose.goal() else {
                if self.no_interior.is_none() {
                    self.interior()?;
                }
                continue;
            };
            let request = Request { goal, ..self.request.clone() };
            let made = Made::new(self.domain, &request, View::Wanted, self.progress);
            self.unless_cancelled()?;
            if let Ok(made) = made {
                self.note(&made);
            }
        }
        let [solver, patch, fewest] = self.made;
        let why = self.no_interior.take().unwrap_or(NoPoints::Unmeasured);
        let mut advice = Advice::among(solver.ok_or(why), patch, fewest);
        if self.is_poor {
            let own = std::slice::from_ref(self.domain);
            advice = advice.and_points_on_edges(own, self.progress);
            self.unless_cancelled()?;
        }
        (self.out)(&AnswerLine::Advice(AdviceAnswer::of(advice)));
        Ok(())
    }

    /// Keeps the figures of a mesh for the advice.
    fn note(&mut self, made: &Made) {
        let (purpose, figures) = match made {
            Made::Interior(found) => {
                self.is_poor = is_poor(found);
                (Purpose::Solver, AdvisedMesh::of_interior(&found.report))
            }
            Made::Boundary(meshed, goal) => {
                let purpose = Purpose::ALL.into_iter().find(|it| it.goal() == Some(*goal));
                let Some(purpose) = purpose else { return };
                (purpose, AdvisedMesh::of(meshed))
            }
            Made::Delaunay(_) => return,
        };
        self.made[purpose as usize] = Some(figures);
    }

    fn shows(&self, part: Part) -> bool {
        self.request.show.contains(&part)
    }

    /// Where a search takes its time, the mesh of the formula comes first: as the mesh of least degree, and as the one that
    /// is wanted until that is found. Whether that is enough of them.
    fn soon(&mut self) -> bool {
        let (is_wanted, is_shown) = (self.shows(Part::Wanted), self.shows(Part::Least));
        let is_asked_for = is_shown || is_wanted && self.request.goal == Goal::LeastDegree;
        // The formula's mesh of a large domain is the mesh of least degree: once is enough.
        if !(is_wanted || is_shown) || is_asked_for && is_by_formula(self.domain) {
            return false;
        }
        let Ok(mesh) = BoundaryMesh::least_degree(self.domain) else { return false };
        self.least(&Figure::for_now(&mesh), false, false);
        !is_asked_for
    }

    /// The mesh of least degree, also as the one that is wanted until that is found.
    fn first_meshes(&mut self) -> Result<(), Cancelled> {
        let (is_wanted, is_shown) = (self.shows(Part::Wanted), self.shows(Part::Least));
        if !is_wanted && !is_shown {
            return Ok(());
        }
        let is_last = self.request.goal == Goal::LeastDegree;
        match Made::new(self.domain, self.request, View::Least, self.progress) {
            Ok(made) => {
                self.note(&made);
                self.least(&Figure::made(self.domain, &made), true, is_last);
            }
            Err(message) => {
                self.refuse(if is_shown { Part::Least } else { Part::Wanted }, message)?;
            }
        }
        Ok(())
    }

    /// Shows a mesh of least degree, as what is wanted too.
    fn least(&mut self, figure: &Figure, is_last: bool, is_last_wanted: bool) {
        for (part, view, is_last) in
            [(Part::Wanted, View::Wanted, is_last_wanted), (Part::Least, View::Least, is_last)]
        {
            if self.shows(part) {
                let shown = figure.shown(view, is_last, self.request);
                (self.out)(&AnswerLine::Mesh(Box::new(shown)));
            }
        }
    }

    /// Makes the mesh of a view, and shows it if its part is asked for.
    fn mesh(&mut self, part: Part, view: View) -> Result<Option<Figure>, Cancelled> {
        match Made::new(self.domain, self.request, view, self.progress) {
            Ok(made) => {
                self.note(&made);
                let figure = Figure::made(self.domain, &made);
                if self.shows(part) {
                    let shown = figure.shown(view, true, self.request);
                    (self.out)(&AnswerLine::Mesh(Box::new(shown)));
                }
                Ok(Some(figure))
            }
            Err(message) => {
                self.refuse(part, message)?;
                Ok(None)
            }
        }
    }

    /// The limit of the angle, and the changes.
    fn changes(&mut self) -> Result<(), Cancelled> {
        if !self.shows(Part::Limit) && !self.shows(Part::Suggestions) {
            return Ok(());
        }
        let limit = changes::limit(self.domain);
        self.unless_cancelled()?;
        if self.shows(Part::Limit)
            && let Some(limit) = &limit
        {
            (self.out)(&AnswerLine::Limit(changes::limit_shown(limit)));
        }
        if self.shows(Part::Suggestions) {
            let suggestions = changes::suggestions(
                self.domain,
                limit.as_ref().and_then(|limit| limit.steps.first()),
                self.progress,
            );
            self.unless_cancelled()?;
            (self.out)(&AnswerLine::Suggestions { suggestions });
        }
        Ok(())
    }

    /// Says why a part has no answer, unless that is because the work was cancelled.
    fn refuse(&mut self, part: Part, message: String) -> Result<(), Cancelled> {
        self.unless_cancelled()?;
        (self.out)(&refused(Some(part), message));
        Ok(())
    }

    fn unless_cancelled(&self) -> Result<(), Cancelled> {
        self.progress.report("answering", 0, 1)
    }
}
