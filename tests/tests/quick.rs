use schuler::math::compensated::Pair;
use schuler::math::real::*;
use schuler::solution::*;
use schuler::strapdown::{frame::*,navigator::*,window::*,local_level::*,earth_fixed::*};
use schuler::trajectory::harmonic::*;
use schuler::trajectory::*;
use schuler::sample::*;
use schuler::imu::*;
use std::f64::consts::PI;
type T=HarmonicTrajectory<f64,32>;
fn paper()->T{
 let d=PI/180.0; let h=|a:f64|vec![Harmonic{amplitude:a,angular_rate:2.0*PI/7200.0,phase:0.0}];
 let (a,l,z)=(h(5.0*d),h(5.0*d),h(2000.0));
 T::new(Channels{roll:Channel{offset:0.0,rate:0.0,harmonics:&a},pitch:Channel{offset:0.0,rate:0.0,harmonics:&a},yaw:Channel{offset:0.0,rate:0.0,harmonics:&a},
 latitude:Channel{offset:45.0*d,rate:0.0,harmonics:&l},longitude:Channel{offset:100.0*d,rate:0.0,harmonics:&l},altitude:Channel{offset:3500.0,rate:0.0,harmonics:&z}}).unwrap()}
fn hard()->T{
 let d=PI/180.0; let w=4.0*PI; let h=|a:f64,w:f64,p:f64|vec![Harmonic{amplitude:a,angular_rate:w,phase:p}];
 let rm=schuler::earth::Radii::at((45.0*d).sin(),(45.0*d).cos()).meridian;
 T::new(Channels{roll:Channel{offset:0.0,rate:0.0,harmonics:&h(5.0*d,w,-PI/2.0)},pitch:Channel{offset:0.0,rate:0.0,harmonics:&h(5.0*d,w,0.0)},yaw:Channel{offset:0.0,rate:0.0,harmonics:&h(5.0*d,2.0*PI/7200.0,0.0)},
 latitude:Channel{offset:45.0*d,rate:0.0,harmonics:&h(0.1/(rm+3500.0),w,0.0)},longitude:Channel{offset:100.0*d,rate:0.0,harmonics:&[]},altitude:Channel{offset:3500.0,rate:0.0,harmonics:&h(0.1,w,0.0)}}).unwrap()}
fn carried(x:&[Increment<f64>])->Vec<Increment<f32>>{let mut c=[0.0f64;6];x.iter().map(|v|{let a=v.angle_b.into_array();let b=v.velocity_b.into_array();let mut o=[0f32;6];for i in 0..6{let x=if i<3{a[i]}else{b[i-3]};let y=x+c[i];o[i]=y as f32;c[i]=y-o[i] as f64;}
 Increment{angle_b:[o[0],o[1],o[2]].into(),velocity_b:[o[3],o[4],o[5]].into()}}).collect()}
fn run<R:Scalar,F:Frame<Real=R>,W:Window>(t:&T,rate:f64,inc:&[Increment<R>])->f64{
 let nav=Strapdown::<F,W>::new(Pair::new(R::narrow(rate)).reciprocal()).unwrap();
 let s0=t.at(0.0).solution();
 let mut st=nav.start(&Solution::narrow(&s0)).unwrap();
 let mut rows=Vec::new();
 for &i in inc{nav.push_rows(&mut st,i,|k,o|rows.push((k,o.wide()))).unwrap();}
 nav.finish_rows(&mut st,|k,o|rows.push((k,o.wide())));
 assert_eq!(rows.len(),inc.len());
 let mut worst=0.0f64;
 for (i,(k,s)) in rows.iter().enumerate(){assert_eq!(*k,i as u64+1);
  let m=t.at(*k as f64/rate);let r=schuler::earth::Radii::at(m.latitude.value.sin(),m.latitude.value.cos());
  let d=|p:Pair<f64>,v:f64|(p.hi-v)+p.lo;
  let n=d(s.position.latitude,m.latitude.value)*(r.meridian+m.altitude.value);let e=d(s.position.longitude,m.longitude.value)*(r.prime_vertical+m.altitude.value)*m.latitude.value.cos();let h=d(s.position.altitude,m.altitude.value);
  let x=(n*n+e*e+h*h).sqrt(); worst=if x.is_nan(){f64::INFINITY}else{worst.max(x)};}
 worst}
#[test] fn go(){
 for (name,t,rate,n) in [("paper",paper(),20.0,36000),("hard",hard(),100.0,6000)]{
  let q=Quadrature::plan(t.bound().bandwidth,1.0/rate);println!("{name} nodes {}",q.evaluations());
  let inc:Vec<_>=(0..n).map(|k|q.increment(&t,k as f64/rate,(k+1) as f64/rate)).collect();
  let f=carried(&inc);
  if name=="paper"{println!("{:?}",inc[0]);println!("{:?}",rates(&t.at(900.0)));}
  macro_rules! g{($($w:ident)*)=>{$( println!("{name} {:8} LL {:.3e} EF {:.3e} f32 LL {:.3e} EF {:.3e}",stringify!($w),
    run::<f64,LocalLevel<Pair<f64>>,$w>(&t,rate,&inc),run::<f64,EarthFixed<Pair<f64>>,$w>(&t,rate,&inc),run::<f32,LocalLevel<Pair<f32>>,$w>(&t,rate,&f),run::<f32,EarthFixed<Pair<f32>>,$w>(&t,rate,&f)); )*}}
  g!(H0B2A0 H0B3A0 H0B4A0 H0B6A0 H2B2A2 H2B2A0 H2B4A0 H4B4A0 H2B4A2 H4B4A4 Line8 Line20);
 }}
