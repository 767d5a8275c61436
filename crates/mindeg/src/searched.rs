//! Meshes with holes by searches with learned clauses: the largest minimum angle for every degree, starting from the
//! meshes of windows.
//!
//! Limits: those of [`Cover`], and a share of the problem's steps for each degree.

use mindeg_exact::{Cover, DegreeRange, degree_range};
use mindeg_mesh::Progress;

use crate::error::MeshError;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;
use crate::trade_off::{ExactMesh, TradeOff, keeps, share_of};
use crate::windowed::{SHARES, windowed};

/// For the angles at each degree, this part of the steps for the least degree.
const SHARE_OF_STEPS: u64 = 4;

/// A domain with holes, and its meshes that windows reach.
pub(crate) struct Searched<'p, 'd> {
    posed: &'p Posed<'d>,
    cover: Cover,
    range: DegreeRange,
    /// Meshes that keep the limits, with their degrees: of those within a degree, the first has the largest angle.
    known: Vec<(u32, Vec<[u32; 3]>)>,
    progress: Progress<'p>,
}

impl<'p, 'd> Searched<'p, 'd> {
    /// None without holes, and for too many candidates.
    pub(crate) fn new(
        posed: &'p Posed<'d>,
        progress: Progress<'p>,
    ) -> Result<Option<Self>, MeshError> {
        if posed.domain().rings().ring_count() == 1 {
            return Ok(None);
        }
        let Some(cover) = Cover::of(&posed.problem, progress)? else { return Ok(None) };
        let range = degree_range(&posed.problem, progress)
            .map_err(|error| posed.unsolved(error, progress))?;
        Self::with_cover(posed, cover, range, progress).map(Some)
    }

    /// Where the least degree was looked for already; none for too many candidates.
    pub(crate) fn of_range(
        posed: &'p Posed<'d>,
        range: DegreeRange,
        progress: Progress<'p>,
    ) -> Result<Option<Self>, MeshError> {
        let cover = Cover::of(&posed.problem, progress)?;
        cover.map(|cover| Self::with_cover(posed, cover, range, progress)).transpose()
    }

    fn with_cover(
        posed: &'p Posed<'d>,
        cover: Cover,
        range: DegreeRange,
        progress: Progress<'p>,
    ) -> Result<Self, MeshError> {
        let mut meshes = Vec::new();
        for share in SHARES {
            match windowed(posed, share, progress) {
                Ok(Meshed { mesh, .. }) => {
                    meshes.push((mesh.max_total_degree(), mesh.triangles().collect()));
                }
                Err(MeshError::LimitsNotReached) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(Self { posed, cover, range, known: meshes, progress })
    }

    /// The mesh with the largest minimum angle that is found within a degree limit.
    ///
    /// # Errors
    ///
    /// A limit below the degree reached.
    pub(crate) fn within(&self, limit: u32) -> Result<ExactMesh, MeshError> {
        let (reached, at_least) = (self.range.max_degree, self.range.lower_bound);
        if limit < reached {
            return Err(if limit < at_least {
                MeshError::excluded(limit, &self.range)
            } else {
                MeshError::not_reached(limit, reached, at_least)
            });
        }
        self.within_from(limit, self.known(limit))
    }

    /// A mesh that is known to keep a degree limit, which is not below the degree reached.
    fn known(&self, limit: u32) -> &[[u32; 3]] {
        let known = self.known.iter().find(|(degree, _)| *degree <= limit);
        known.map_or(&self.range.triangles, |(_, triangles)| triangles)
    }

    /// The mesh with the largest minimum angle that is found, from one that keeps the limit.
    fn within_from(&self, limit: u32, known: &[[u32; 3]]) -> Result<ExactMesh, MeshError> {
        let found = self.cover.largest_angle(
            &self.posed.problem,
            limit,
            known,
            &mut (self.posed.problem.max_steps() / SHARE_OF_STEPS),
            self.progress,
        )?;
        let mesh = self.posed.mesh(found.triangles)?;
        let (min_angle, is_proven) = (found.min_angle, found.is_largest);
        Ok(ExactMesh { max_degree: limit, min_angle, is_proven, mesh })
    }

    /// The mesh of [`within`](Self::within), with what is known of the least degree.
    pub(crate) fn max_degree(&self, limit: u32) -> Result<Meshed, MeshError> {
        let exact = self.within(limit)?;
        Ok(self.meshed(&exact, exact.is_proven))
    }

    /// The mesh of the smallest degree that is found to keep a share of Delaunay's minimum angle. At smaller degrees the
    /// largest angle is not asked for, only whether it is large enough.
    pub(crate) fn keep_angle(&self, share: f64) -> Result<Meshed, MeshError> {
        let (delaunay, problem) = (self.delaunay(), &self.posed.problem);
        let (highest, most) = self.highest()?;
        let is_enough = |angle: f64| angle >= most || keeps(angle, share, delaunay);
        let mut is_exact = self.range.is_proven();
        for limit in self.range.max_degree..=highest {
            let (known, steps) = (self.known(limit), problem.max_steps() / SHARE_OF_STEPS);
            let found =
                self.cover.reaches_angle(problem, limit, is_enough, known, steps, self.progress)?;
            let Some(Some(triangles)) = found else {
                is_exact &= found.is_some();
                continue;
            };
            let mut exact = self.within(limit)?;
            if !is_enough(exact.min_angle) {
                exact = self.within_from(limit, &triangles)?;
            }
            return Ok(self.meshed(&exact, is_exact && exact.is_proven));
        }
        // Every degree is left undecided.
        Ok(self.meshed(&self.within(highest)?, false))
    }

    fn meshed(&self, exact: &ExactMesh, is_proven: bool) -> Meshed {
        let share = share_of(exact.min_angle, self.delaunay()).min(1.0);
        Meshed {
            mesh: exact.mesh.clone(),
            least_max_degree: self.range.lower_bound,
            is_least_proven: self.range.is_proven(),
            found_by: if is_proven { FoundBy::Search } else { FoundBy::Windows { share } },
            delaunay_min_angle: self.posed.delaunay_min_angle,
        }
    }

    /// Delaunay's minimum angle.
    fn delaunay(&self) -> f64 {
        self.posed.delaunay_min_angle.unwrap_or(0.0)
    }

    /// The largest degree that is of use, and the angle that a mesh has with it.
    fn highest(&self) -> Result<(u32, f64), MeshError> {
        let least = self.range.max_degree;
        if self.posed.domain().is_constrained() {
            // With degree limits of single vertices, no mesh may have Delaunay's angle.
            let any = self.within(u32::MAX)?;
            return Ok((any.mesh.max_total_degree().max(least), any.min_angle));
        }
        let highest = self.known.iter().map(|(degree, _)| *degree).max().unwrap_or(least);
        Ok((highest.max(least), self.delaunay()))
    }

    /// The best mesh for every degree, up to the first that is enough or has the largest angle of all. Degrees
    /// without a better mesh than the one before are left out.
    pub(crate) fn trade_off(
        &self,
        mut is_enough: impl FnMut(f64, f64) -> bool,
    ) -> Result<TradeOff, MeshError> {
        let delaunay = self.delaunay();
        let (highest, most) = self.highest()?;
        let mut meshes = Vec::<ExactMesh>::new();
        for limit in self.range.max_degree..=highest {
            let exact = self.within(limit)?;
            let is_last = exact.min_angle >= most || is_enough(exact.min_angle, delaunay);
            if meshes.last().is_none_or(|last| last.min_angle < exact.min_angle) {
                meshes.push(exact);
            }
            if is_last {
                break;
            }
        }
        let is_least_proven = self.range.is_proven();
        Ok(TradeOff::new(self.posed.domain(), meshes, delaunay, is_least_proven))
    }
}
