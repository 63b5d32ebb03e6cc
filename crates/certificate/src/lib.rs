//! Saved limit-analysis solutions, and proofs of the bounds they claim.
//!
//! A collapse load in plane strain is bounded from below by any *statically admissible* stress field and from above by any
//! *kinematically admissible* velocity field. [`prove_lower`] and [`prove_upper`] check such fields with interval
//! arithmetic whose ends are rounded outwards, and return the bound that is then *proven* for exactly the numbers of the
//! [`Statement`]. They share no code with the solver that made the fields and trust nothing in them: a field from
//! elsewhere, altered or wrong, either proves a true bound or is refused with a reason.
//!
//! ```no_run
//! use soilctl_certificate::{Solution, prove};
//!
//! let proof = prove(&Solution::read("solution.json".as_ref())?)?;
//! for (name, bound) in [("lower", proof.lower), ("upper", proof.upper)] {
//!     if let Some(bound) = bound {
//!         println!("{name} bound: {} proven, {} claimed", bound.proven, bound.claimed);
//!     }
//! }
//! # Ok::<(), soilctl_certificate::CertificateError>(())
//! ```
//!
//! # The two theorems
//!
//! Tension is positive. `s` is the total stress, `u` the pore pressure, `p = (xx + yy)/2 + u` the mean effective stress and
//! `r = sqrt(((xx - yy)/2)^2 + xy^2)` the radius of Mohr's circle. For a velocity `v`, `e = exx + eyy` is the dilation and
//! `g = sqrt((exx - eyy)^2 + 4 exy^2)` the shear rate. Mohr-Coulomb soil with friction angle `phi`, cohesion `c` and, if its
//! tension is limited, greatest effective tension `t` bears the convex set of stresses
//!
//! ```text
//! K = { s :  r <= c cos(phi) - p sin(phi),   p + r <= t }
//! ```
//!
//! Its support function is what a strain rate can dissipate at most. It is finite only on the cone of the flow rule:
//!
//! ```text
//! D(v) = sup { s : e(v)  |  s in K } <= (c cot(phi) - u) e                   if  e >= g sin(phi), infinite otherwise
//!                                    <= (t - u) e + Q max(g - e, 0),         Q = max(0, (c cos(phi) - t sin(phi))/(1 - sin(phi)))
//! ```
//!
//! Without friction and limit to the tension, `e = 0` and `D(v) = c g`.
//!
//! With an [envelope](Envelope) soil bears `r <= c_k cos(phi_k) - p sin(phi_k)` for each of several lines. `D(v)` is then at most the greatest
//! `(p - u) e + r g` of the corners at which these meet, if `e >= g sin(phi)` for the flattest. The static theorem takes the inner lines, the
//! kinematic one the outer ones, which are proven to be nowhere below them; so both hold for every strength between.
//!
//! Of [clay whose strength depends on the direction](Anisotropy) `r` is the distance from the middle of the ellipse over its half-axes, and `D(v) =
//! c (E (exx - eyy) + sqrt((A (exx - eyy))^2 + (B 2 exy)^2))` with `E`, `A`, `B` middle and half-axes for a cohesion of one.
//!
//! Let `b` be the dead body force, `T` the dead tractions, `m` the factor on the live ones `b'`, `T'`, and `F` the force of
//! the structure on the soil per unit width, times its velocity `V`.
//!
//! ```text
//! static theorem      div s + b + m b' = 0 in the soil,  s n = T + m T' on loaded sides,  s n continuous,  s in K
//!                     =>  F(s), or m, is a lower bound
//!
//! kinematic theorem   v = 0 on fixed sides,  v . n = 0 on smooth ones,  e >= g sin(phi),  opening >= |slip| tan(phi)
//!                     =>  int D(v) + int D([v]) - W(v), or that over P(v), is an upper bound
//! ```
//!
//! with `W` the power of the dead loads and `P > 0` that of the live ones. Both follow from virtual work: for a stress field
//! and a velocity field as above
//!
//! ```text
//! F(s) + W(v) + m P(v)  =  int s : e(v) + int (s n) . [v]  <=  int D(v) + int D([v])
//! ```
//!
//! Over all fields, the greatest lower and the least upper bound are a pair of dual cone programs, and their common value is
//! the *collapse load* (Drucker, Prager & Greenberg 1952). What is proven here is weak duality for given fields; that they
//! are the best ones is not claimed.
//!
//! # What is bounded
//!
//! - [`Objective::Structure`]: `F`, the largest that a statically admissible stress field can have.
//! - [`Objective::Loads`]: the largest factor `m` on all live loads for which there is such a stress field.
//! - [`Objective::Body`]: the same for a body force that is added to gravity.
//! - [`Objective::Everything`]: the largest factor on gravity, pore pressure, surcharge and all loads together.
//!
//! A [face](Condition::Face) bears `|shear| <= adhesion - (normal + u) tan(delta)`, a frictionless one without adhesion
//! `normal + u <= 0` only. Soil beyond [far](Condition::Far) lines is part of it: to the left and right of the mesh, below
//! it, or all around. Its cohesion is that along the line. Where such soil adjoins a [fixed](Condition::Fixed) or
//! [smooth](Condition::Smooth) wall or base at a corner of the mesh, that goes on for ever too.
//!
//! # Every interval holds the true number
//!
//! Each operation returns an interval that holds the true result if the arguments hold theirs, so the checks hold for
//! real numbers. Vertices on lines and on points of the statement are exactly there. Zeros that follow from the
//! construction, such as `x - x` for one `x`, are not computed at all, so inequalities that hold with equality there
//! can be proven.
//!
//! # The mesh covers the soil once
//!
//! Lines of the statement are proven not to cross, and beyond each side that has soil on one hand only there is proven
//! to be none, so regions do not overlap. All triangles are proven to be counter-clockwise. Each edge is either paired
//! with one of the same region or lies on a loop of its region, in the loop's sense, and the latter cover the loops once.
//! So the boundaries of all triangles of a region add up to its loops, and the number of triangles over a point is the
//! loops' winding number around it: one in the region, zero outside.
//!
//! # Upper bound
//!
//! The velocity `v` is zero far away; at faces of the structure `v - V` jumps. If a factor is bounded, `V` is zero. With
//! [`Objective::Everything`] water is one of the live loads, so `P` has the `u e` and `u o` that are said below to lessen
//! `D`. Integrals of polynomials are exact but for rounding.
//!
//! *Soil with friction* has a velocity quadratic on each triangle. Its strain rate must obey the flow rule `e >= g
//! sin(phi)`; then the power of the effective stress is at most `c cot(phi) e`. Jumps and faces are thin layers: with
//! opening `o` and slip `s`, `o >= |s| tan(phi)`, and the power is at most `c cot(phi) o`. The cones are convex: strain
//! rates, linear on a triangle, obey at the corners and hence everywhere; jumps, quadratic along an edge, obey at Bernstein
//! control points and hence everywhere.
//!
//! - *Jumps between two soils* may use either, since the traction is within the strength of both, each with its own pore
//!   pressure.
//! - *Cohesion* is linear, and more of it never dissipates less, so it may be taken as zero where rounding makes it less.
//! - *Pore pressure* `u` adds `-u e` and `-u o`, at faces that of the soil there.
//! - *A greatest tension* `t` cuts the cone off. The power is then at most `t e + Q max(g - e, 0)` too; in a layer `e = o`
//!   and `g = sqrt(o^2 + s^2)`. Both factors are convex and not
//!   negative, so they are at most the linear functions through their values at corners, and at most the polynomials that
//!   have their values at control points as coefficients. The lesser of the two bounds counts.
//! - *An envelope* dissipates a convex and homogeneous function of the strain rate, or of opening and slip: at most the linear function through
//!   its values at the corners, or the polynomial with those at the control points as coefficients.
//!
//! *Soil without friction* has the velocity `(s_y, -s_x)` of a stream function, the piecewise cubic of the lower bound with
//! the same gluing: no volume changes and nothing jumps, by construction. It dissipates `c g`; `g` is convex
//! in the strain rate, so in each part it is at most the linear function through its values at the nodes. With a limit to its
//! tension it may tear, and may flow like soil with friction, with `sin(phi) = 0`.
//!
//! - *Walls.* Where the velocity across a side is given, `s` is linear along it and known but for a constant that is
//!   common to the whole run of such sides ([`StreamJet`]): from `a` to `b` it grows by `V_x (b - a)_y - V_y (b - a)_x`. On
//!   an edge, `s` is cubic, so it is that function if values and slopes at the ends are. Around a closed run the changes
//!   must add up to zero: what moves across itself is closed. On fixed and far sides the slopes at both ends and the one
//!   across the middle are zero, and so is the velocity.
//! - *Adhesion* `a` dissipates `a |slip|` at such faces, at most the polynomial with these values as coefficients.
//! - *Elsewhere* (frictionless faces, loads, soil with friction or at rest beyond) the velocity on an edge is quadratic:
//!   its part across is the derivative of the cubic, its part along follows from both ends and the middle.
//! - *Cracks.* Triangles that do not share their vertex copies may move apart as a layer of soil without friction, if its
//!   tension is limited.
//!
//! # Lower bound
//!
//! The stress is a reference stress plus `xx = f_yy, yy = f_xx, xy = -f_xy` of an Airy stress function `f` with continuous
//! slopes, cubic on each third of a triangle (the Clough-Tocher macro-element). The reference is in equilibrium with the
//! weight. The rest needs no force: it is in equilibrium with itself in each part, and tractions on an edge are derivatives
//! along the edge of the slopes, which both sides share.
//! *So equilibrium holds by construction*: both sides of an edge take value and slopes at its ends from the same vertex
//! copies and the slope across its middle from the same number; a cubic and its quadratic slope across are determined by
//! these. What is proven is the force on the structure, or, for the other objectives, [`LowerField::multiplier`]: it only
//! enters by the reference and the loads. With [`Objective::Everything`] the field is the `m`-th part of the stress that goes
//! with the factor `m`: in equilibrium with what acts, and within the strength of soils and faces with the `m`-th part of their
//! cohesion, adhesion and greatest tension; `m` times that is in equilibrium with `m` times all that acts, and within the
//! strength. Affine functions carry no stress: an Airy stress function is known up to one.
//! *Gauges* ([`LowerField::gauges`]) are affine functions of this kind; values are stored relative to one of them, so that
//! small differences are kept without loss.
//!
//! - *Reference.* All regions have the base, made with the unit weight `w` of the first: with depth `d` below the datum,
//!   gravity `g`, surcharge `q` and `t = g_x/g_y` it is `yy = w g_y d - q, xy = w g_x d, xx = (1 + 2 t^2) w g_y d - q`. A
//!   bounded body force `h` adds `m w h_y d` to both normal stresses and `m w h_x d` to the shear stress. If unit weights
//!   differ, gravity and body force are vertical, and a region of unit weight `w + e` has a column part besides: `yy = C(x,
//!   y)`, linear, with `C_y = -e (g_y + m h_y)`, which balances the rest of its weight. `C` is zero if `e` is and that of all
//!   regions above is. If not, `C` is that of the region above on the line between the two; of several such lines, all
//!   are at one height and what is above them has the same column part. Where no other region is above, `C` is zero on the
//!   line that is the top of the region or, if that is not one line or one height, at the datum. So `C n_y`, the traction
//!   of the column part, is the same on both sides of all interfaces: on vertical ones it is zero.
//! - *Free and loaded edges.* Let `T` be the given traction, less that of the reference, times the length of a side walked
//!   with the soil on the left; both are linear. Tractions of `f` add up to the change of `(f_y, -f_x)`. So along a run of
//!   such sides `f` is an affine function, the run's gauge, plus one that is zero with its slopes where the run
//!   starts and whose slopes change by the integral of `T` turned left. It is a cubic on each side: value and slopes at both
//!   ends of an edge and the slope across its middle carry it over exactly. It goes on from side to side in one way, and a
//!   vertex copy is at one place of one run only, so all edges at a copy take the same value and slopes from it.
//! - *Branch cuts.* A function that is single-valued all around a body carries no force on it. So an edge inside the soil
//!   may have other vertex copies on its two sides: alike, but relative to two gauges, the same two at both ends. Then the
//!   function beyond the edge, with its slopes, differs by no more than the affine function between these gauges, which
//!   carries no stress, so tractions are the same on both sides. A run of free or loaded sides goes on with another gauge
//!   beyond a copy where such edges end: there both copies are at one place of the run.
//! - *Lines of given shear.* With `n = to - from` turned left, the slope across `g = grad f . n` has `g' = t . ref n` (no
//!   shear stress) or `g' = 0` (far lines: that of the reference). This makes it a known quadratic polynomial but for a
//!   constant, which comes from the first gauge that the line touches or from [`LowerField::lines`]. The slope across an
//!   edge equals `g` if it does at both ends and in the middle. Lines that follow each other along the soil share the
//!   constant if they are all level or all vertical: there `g` over the signed length of `n` is `f_y` or `-f_x`, and its
//!   derivative is the shear stress of the base, whatever the region.
//! - *Apexes.* On free sides without surcharge of soil without cohesion the stress must vanish; on [submerged](Condition::Submerged)
//!   ones the effective stress, to which the same applies with `reference + u I` for the reference. Then all second derivatives of `f`
//!   are known there, and a cubic polynomial `q` of the side has them: with `p = start + s t + e n`, `t` along the side and `n` that
//!   turned left,
//!
//!   ```text
//!   q = v(s) + e w(s) - e^2/2 (t . ref t)(s),      v, w: value and slope along n, as the run demands
//!   ```
//!
//!   Its stress and the reference's add up to one that is zero on the side, grows with the distance from it and balances the weight.
//!   At all vertex copies on such sides, the apexes, all Bernstein coefficients of `f - q` up to two steps away are zero
//!   (beyond the gauge). The one next to a neighbour `C` of an apex `T` is `f - q + grad (f - q) . (T - C)/3` = 0, which restricts the
//!   [`Jet`] of `C`: its numbers are those of `f - q`. The conditions for continuous slopes across and within triangles then hold as for
//!   the general element; those along lines of given shear do since there is no shear stress at an apex. Where two such sides meet,
//!   their polynomials differ by a cubic that vanishes to second order there. So a triangle may take that of any side that
//!   all its apexes are on, a vertex that of any side that all apexes next to it are on; where there is no such side, the field is
//!   refused. On sides at the datum, up to which the run has no tractions, `q` is zero.
//! - *Strength.* Stress, cohesion and pore pressure are linear on each part, lines of an envelope are the same everywhere, and what is borne is a convex set of all
//!   three together, so the part's three nodes decide; so do both ends of a face edge.
//! - *Force.* Tractions of `f` on a piece of boundary, soil on the left, add up to the change of `(f_y, -f_x)`.
//!
//! # Beyond far lines
//!
//! Let `B` be the base of the reference. With vertical gravity, `B_xy` is zero.
//!
//! - *Beside a vertical far side* the layers along it go on level, up to a level surface at the height of the side's
//!   upper end. At each height the stress is `xx` of the mesh at the line, `yy` that of what lies above there, from the
//!   surcharge on the surface on, and `B_xy`.
//! - *Below a level far side* it is `xx = X(y)`, `yy` of the mesh at the line plus what the weight adds with depth, and
//!   `B_xy`. At the line, `X` is `B_xx` plus [`LowerField::far_stress`]; from there on it changes as the base of soil of the
//!   unit weight there would, which is one for all soil beyond that side and for the lowest layers beside.
//! - *In the quadrants beyond both* it is `xx = X(y)`, `yy` as beside at the lowest point plus what the weight adds, and
//!   `B_xy`.
//!
//! Each balances: `xx` does not vary along x, nor does `xy`; `yy` varies along y as the weight demands, and `xy` is zero, or
//! that of the base where gravity is not vertical, which is then allowed only for one unit weight and a surface at the
//! datum. On each line between two of these the parts that act across it are the same: `xy` is `B_xy` everywhere (in the
//! mesh because `g' = 0` and column parts do not shear); `xx` continues across vertical lines, where `X` depends on y only;
//! `yy` continues across level ones, also between layers. It need not continue across vertical ones, so levels on the left
//! and right may differ. On the surface `yy` is the surcharge and `xy` zero.
//!
//! Strength is proven at both ends of each edge, with the soil of that edge, and in the corners; between, all is linear.
//! Pore pressure beside a vertical far side does not vary along x, and below it goes on with the depth as it does inside.
//! Downwards an effective stress state moves along the gradient of the base plus that of the pore pressure, which is
//! proven to be within the cone of the strength without cohesion and tension, so it stays within.
//!
//! # Members
//!
//! A [`Member`] goes along lines inside the soil that are in one line: level, upright, or one only. It bears an axial force `-compression <= N <=
//! tension`, and if it is no beam no moment and no force across. With `t` along it and `n` to its left, let `T` be the tractions on the soil at both faces; then
//!
//! ```text
//! balance             T(left) + T(right) = t dN/ds,    |T . t| <= bond (c - (normal + u) tan(phi))  on each face,
//!                     N = 0 at ends that are not attached; others pull what they are attached to
//! kinematics          w: velocity along t;  opening >= bond |slip| tan(phi)  between each soil and the member
//! virtual work        N(end) w(end) - N(start) w(start)  =  int N dw + int t . (T(left) + T(right)) w
//! dissipation         int max(tension dw, -compression dw)  +  on each face  int (t' - u) opening + bond max(0, c - t' tan(phi)) |slip|
//! ```
//!
//! Beside clay whose strength depends on the direction, a face bears the part `bond` of the greatest shear stress that the clay bears along it, either
//! way, and dissipates that part of what a layer of clay along it takes up.
//!
//! with `t'` the soil's greatest tension, or `c cot(phi)`, which leaves no term in `slip`; without friction nor limit to the tension the opening is zero.
//!
//! *Lower.* The normal slope of `f` is more on the member's left than on its right by `N`; `f` and its slope along `t` are the same. That is so on an
//! edge if, at each end, the jets on both sides are one but for a multiple of `n` ([`Jet::Kinked`]), for the slope across is
//! quadratic and given in the middle on each side. So tractions balance as above by construction, and `N` is quadratic: within its limits if its
//! Bernstein coefficients are. Directions are exactly those of the lines; hence the condition that these be level or upright, or one.
//!
//! *Upper.* The member's velocity along itself is quadratic on each edge; it may jump between edges, and to what an end is attached to. Its total
//! rise and fall are no more than those of its Bernstein coefficients, one after the other. The velocity across has no part in the power, so it need not be
//! continuous. Beside soil that keeps its volume it is that soil's: the stream functions of both sides have one value and one slope along
//! `t` there ([`StreamJet::Kinked`]).
//!
//! At the toe of a wall that moves, on ground that does not, all velocities between meet. There triangles have jets of their own, which differ across an edge by a
//! multiple of the edge's normal ([`StreamJet::Slip`], [`StreamJet::SlipAtWall`]): the stream function and its slope along the edge are one on both sides, so nothing passes
//! through the edge, and what slips along it dissipates as in any other layer.
//!
//! *Bars in rows* ([`Member::pullout`]): the soil goes on between them. In plane strain they are smeared over their spacing; what stands for the
//! soil's grip on them is a greatest force `q` for each length, along themselves and either way, whatever the stress beside them is. They have no faces. With
//! `s` their slip, so that they move at `z + s` along themselves, where `z` is a velocity that the flow chooses for the soil right at them,
//!
//! ```text
//! balance             T(left) + T(right) = t dN/ds,    |dN/ds| <= q;    stresses on either side are limited by the soil's own strength alone
//! virtual work        N(end) w(end) - N(start) w(start) - int T . v  =  int N dw + int dN/ds s - int T . (v - z),    w = t . z + s,  both sides
//! dissipation         int max(tension dw, -compression dw) + int q |s| + that of a layer of the soil on each side, between its velocity v and z
//! ```
//!
//! The traction on each side is one that the soil there bears, so a layer of it dissipates no less than `-T . (v - z)`, as beside a sheet whose `bond` is
//! one. Soil that moves as one has `v = z` on both sides and dissipates nothing there. So a row of bars bears no less than the ground without
//! it (`N = 0`), no more the less it is held, and at most what a sheet does whose `bond` is one, which is the case of boundless `q`.
//!
//! `N` is quadratic along an edge, so `dN/ds` is linear, as `q` is: it is within `q` if it is at both ends. Where `q` is zero, or not given on all of an
//! edge, `N` is one number along it: both kinks are the same multiple of the normal of one line, and the slope across the middle on the right is made of
//! that on the left and `N`. The kinematic side takes the full `q` on such an edge. `|s|` is at most the quadratic polynomial with the sizes of its coefficients.
//!
//! A *beam* is a member with [`Bending`]. It bears a moment and a shear force besides, `|M| <= moment`, `|V| <= shear`, whatever its other
//! forces are, and is stiff across itself. With `T` as above, `u` its velocity to its left, and the load on its other side in place of
//! `T` where it [lines](Condition::Lined) the soil,
//!
//! ```text
//! balance             (T(left) + T(right)) . n = -dV/ds,    V = dM/ds;    M = V = N = 0 at ends that are not clamped
//! virtual work        int M d(u') + sum V [u]  over the jumps of u  =  what the tractions of the soil and the loads do
//! dissipation         int moment |d(u')| + sum shear |[u]|
//! ```
//!
//! *Lower.* `f` and its slopes are independent on both sides: `M`, `V` and `N` are the jumps of `f`, of its slope along `t` and of that along
//! `n`. Where the beam lines the soil, the function beyond is that of the loads on its run, which goes on past the beam; an end is free if
//! both sides have one copy there, or the run's. `M` is cubic on an edge. Another member may be attached to the beam: its force is the kink
//! of `f`, by which `V` and `N` jump. Without branches, so without bodies in the soil.
//!
//! *Upper.* `u` is quadratic on an edge; `u'` changes by the difference of its values at the ends there, and what `u` and `u'` jump by from one
//! edge to the next, and to what clamps an end, counts in full.
//!
//! # Structures with ends
//!
//! With [`Statement::width`] the statement is the section of thin sheets that move together in one soil without water, level above, and
//! has that width across the plane, `|y| < w/2`; the soil goes on beyond. Bounds are per unit width. All but lower bounds in the plane are of a
//! single straight plate that hangs from the surface.
//!
//! *Lower.* The field is one in plane strain as above, and is spliced with the ground at rest: between the ends it has any
//! normal pressure `f(x, z)` across, beyond them the stress is the reference's base with the same `f` across. As `f` does not
//! vary with y, both parts balance and their tractions agree; thin side plates in the planes of the ends would carry nothing. Such an `f` exists if and only if at each point, with `p1 >=
//! p3` the principal pressures in the plane and `o1 >= o3` those of the ground at rest,
//!
//! ```text
//! p1 + c cot(phi) <= K^2 (o3 + c cot(phi)),   o1 + c cot(phi) <= K^2 (p3 + c cot(phi)),   K = (1 + sin(phi))/(1 - sin(phi))
//! ```
//!
//! which is proven besides yield, also beyond far lines. The bound then holds for every width. Two flows in the plane cannot
//! be spliced: between them the soil would shear without opening.
//!
//! *Lower, in space.* For an upright plate in soil with weight and friction only, [`prove_space`] proves a [`SpaceStress`]: stresses in
//! tetrahedra about each end, linear in the four parts of each, and a plane stress field between. They follow from what presses
//! on faces, and are in equilibrium if forces and moments on each tetrahedron balance. In the numbers of a file they do not
//! quite; it is proven that close to these there are others that do.
//!
//! *Upper.* A [`Mechanism`] of rigid blocks in translation, bounded by triangles, is proven by [`prove_mechanism`]. Its
//! velocity `v` jumps by `[v]` across facets with the area vector `N`. Virtual work demands of them
//!
//! ```text
//! [v] . N >= |[v]| |N| sin(phi),        F . V <= sum of c cot(phi) [v] . N  +  the same at the plate  -  W
//! ```
//!
//! and needs neither convex blocks nor blocks that are apart: where they overlap their velocities add up, and so do jumps,
//! which then still obey. Blocks stay on one side of the plate, their facets close up and cover its faces once.
//!
//! # What is not covered yet
//!
//! Lower bounds with
//!
//! - free or loaded boundary all around the soil or a hole;
//! - loads that begin beside a free side of soil without cohesion, which bears none there, and such sides where a region of another unit
//!   weight whose top lies elsewhere meets them;
//! - a region under several tops where unit weights differ, and gravity that is not vertical there;
//! - adhesion without friction on soil with friction, and interface friction on soil without;
//! - more than two lines of given shear, or parallel ones that are not joined, that meet; sloping ones between soils of
//!   different unit weight;
//! - members that meet, other than with an end at a beam, attached only between its ends; that go through points of boundaries, where a beam may if these are free or loaded; that
//!   are attached to far lines, or to lines of given shear other than at right angles; beams attached to anything but fixed lines, or beside bodies;
//! - far lines other than a frame of the mesh, different unit weights beyond the one below, and pore pressure that varies
//!   along x beside vertical ones.
//!
//! Upper bounds with friction at faces in soil without friction, with adhesion alone at faces in soil with friction, and
//! with a closed wall of soil without friction of which only a part moves.
//!
//! # Sources
//!
//! - Clough & Tocher (1965), Finite element stiffness matrices for analysis of plate bending. Conf. Matrix Methods in
//!   Structural Mechanics, Wright-Patterson AFB. Bernstein form: Lai & Schumaker (2007), Spline Functions on Triangulations.
//! - Drucker, Prager & Greenberg (1952), Extended limit design theorems for continuous media. Q. Appl. Math. 9, 381-389.
//! - Makrodimopoulos & Martin (2006, 2007): the cones and the convexity arguments for stresses and strain rates that are
//!   linear on a simplex. Int. J. Numer. Methods Eng. 66, 604-634; Int. J. Numer. Anal. Methods Geomech. 31, 835-865.

mod element;
mod ends;
mod error;
#[cfg(test)]
mod examples;
mod fields;
mod interval;
mod lower;
mod mesh;
mod problem;
mod proof;
mod runs;
mod shown;
mod solution;
mod statement;
#[cfg(test)]
mod tests;
mod tiling;
mod upper;

pub use ends::{
    EndForce, ShownFace, ShownPart, ShownSpace, SpaceSection, SpaceStress, prove_end, prove_mechanism,
    prove_space, show_mechanism, show_space,
};
pub use error::CertificateError;
pub use fields::{
    BeyondFacet, Facet, Flow, Gauge, Gradient, Jet, LowerField, Mechanism, MemberFlow, MemberMotion,
    Position, StreamCopy, StreamJet, UpperField, Velocity, VertexCopy,
};
pub use lower::prove_lower;
pub use mesh::{Mesh, Place, Side, Triangle, Vertex};
pub use proof::{Bound, Checked, Proof, check, check_lower, check_upper, prove};
pub use runs::Run;
pub use shown::{
    Adjoins, FlowPiece, ShownAcross, ShownFlow, ShownMember, ShownStress, show_flow, show_stress,
};
pub use solution::{Claim, Computed, MAX_FILE_BYTES, SCHEMA, Scale, Solution};
pub use statement::{
    Anisotropy, Bending, Boundary, Condition, Envelope, Grip, Line, LineUse, Linear, Material, Member,
    Objective, Region, Statement, StrengthLine,
};
pub use upper::prove_upper;
