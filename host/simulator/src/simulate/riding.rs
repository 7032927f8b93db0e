//! An aided navigator as the vehicle of a run.

use super::{Refused, Vehicle};
use crate::aided::navigator::Aids;
use crate::aided::report::{Judgement, Report};
use crate::aided::smoother::Smoothed;
use crate::aided::vehicle::AidedVehicle;
use crate::flight::Nine;
use crate::navigator::{Navigate, Reader};
use schuler::aiding::aided::fault::AidedFault;
use schuler::sample::Increment;
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// What an aided navigator says of itself, for whoever reads its rows.
#[derive(Clone, Default)]
pub struct Claims {
    /// Standard deviations of its drift at the last row.
    pub sigma: Rc<Cell<Nine>>,
    /// Columns of what it estimates beside the motion.
    pub estimated: Rc<RefCell<Vec<String>>>,
    /// Their numbers at the last row.
    pub estimates: Rc<RefCell<Vec<f64>>>,
    /// Every measurement as it was judged, once it has ended.
    pub judged: Rc<RefCell<Vec<Judgement>>>,
    /// Its smoothed states, once it has ended.
    pub smoothed: Rc<RefCell<Vec<Smoothed>>>,
    /// What became of the measurements, once it has ended.
    pub report: Rc<RefCell<Option<Report>>>,
}

impl Claims {
    /// Says what a drift is by its covariance.
    pub fn claim(&self, covariance: &[[f64; 9]; 9]) {
        self.sigma.set(Nine::of_covariance(covariance));
    }
}

/// An aided navigator.
pub struct Riding {
    vehicle: AidedVehicle,
    /// The same unaided, whose time is taken.
    unaided: Box<dyn Navigate>,
    claims: Claims,
}

impl Riding {
    /// With one that is not aided, whose time is taken.
    pub fn new(vehicle: AidedVehicle, unaided: Box<dyn Navigate>, claims: Claims) -> Self {
        let riding = Self { vehicle, unaided, claims };
        *riding.claims.estimated.borrow_mut() = riding.aided().estimated();
        riding.claim();
        riding
    }

    fn aided(&self) -> &dyn Aids {
        self.vehicle.navigator()
    }

    /// Says what its drift is, and what it estimates.
    fn claim(&self) {
        self.claims.claim(&self.aided().covariance());
        self.aided().estimates(&mut self.claims.estimates.borrow_mut());
    }

    /// Reads the row of a block that has ended since.
    fn read(&self, before: u64, read: &mut Reader) {
        let navigator = self.aided();
        if navigator.integrated() != before {
            self.claim();
            read(navigator.integrated(), &navigator.solution());
        }
    }
}

impl From<AidedFault> for Refused {
    fn from(fault: AidedFault) -> Self {
        match fault {
            AidedFault::Rejected(why) => Self::Rejected(why),
            other => Self::Aiding(other),
        }
    }
}

impl Vehicle for Riding {
    fn push(&mut self, sample: &Increment<f64>, read: &mut Reader) -> Result<(), Refused> {
        let before = self.integrated();
        self.vehicle.push(sample)?;
        self.read(before, read);
        Ok(())
    }

    fn hold_vertical(&mut self, _: f64, _: f64) -> Result<(), Refused> {
        // A scene that is aided holds nothing.
        Ok(())
    }

    fn finish(&mut self, read: &mut Reader) -> Result<(), Refused> {
        let before = self.integrated();
        self.vehicle.finish()?;
        self.read(before, read);
        *self.claims.judged.borrow_mut() = self.aided().judged().to_vec();
        *self.claims.smoothed.borrow_mut() = self.aided().smoothed();
        *self.claims.report.borrow_mut() = Some(self.vehicle.report());
        Ok(())
    }

    fn break_off(&mut self, read: &mut Reader) {
        // What ended the run is told; this is what came before it.
        let _ = self.finish(read);
    }

    fn integrated(&self) -> u64 {
        self.aided().integrated()
    }

    fn digest(&self) -> u64 {
        self.aided().digest()
    }

    fn navigator(&self) -> &dyn Navigate {
        self.unaided.as_ref()
    }
}
