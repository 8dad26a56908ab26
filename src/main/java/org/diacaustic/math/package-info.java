/**
 * Vectors, rays, bounds, roots, refraction and random streams: arithmetic that knows no scene. Lengths are in scene
 * units, angles in radians unless a name says degrees. Start reading at {@link org.diacaustic.math.Ray}.
 *
 * <p>Sources cited in this project: [Thesis] is H. A. Bailey, <i>Ray Tracing Techniques for Indirect Refracted
 * Illumination</i>, 1999, with its section. [Haines et al. 2019] is "Precision Improvements for Ray/Sphere
 * Intersection" in Ray Tracing Gems. [Kahan 2004] is "On the Cost of Floating-Point Computation Without Extra-Precise
 * Arithmetic". [Jeannerod, Louvet and Muller 2013] is "Further Analysis of Kahan's Algorithm for the Accurate
 * Computation of 2×2 Determinants". [Higham 2002] is Accuracy and Stability of Numerical Algorithms, second edition.
 * [Ize 2013] is "Robust BVH Ray Traversal" (JCGT 2). [Born and Wolf 1999] is Principles of Optics, seventh edition.
 */
package org.diacaustic.math;
