/**
 * Surfaces that rays meet, and the inverse mappings from their points to coordinates of a map. Read {@link
 * org.diacaustic.shape.Shape} first, then {@link org.diacaustic.shape.Sphere}, the shortest example of all its promises;
 * the contract test asks them of every shape.
 *
 * <p>Every shape solves its equation as it stands and leaves out the root at which a ray starts, by dropping the constant
 * term; none compares a distance with a smallest one. Solids that are convex (box, frustum, sphere, ellipsoid) are met in
 * one piece, so that a ray which enters them leaves them again, even through an edge or a tip.
 *
 * <p>Sources: [Thesis] H. A. Bailey 1999. [Haines 1987] A proposal for standard graphics environments, IEEE Computer
 * Graphics and Applications. [Haines 1991] Essential ray tracing algorithms, in Glassner (ed.), An Introduction to Ray
 * Tracing. [Haines 1994] Point in polygon strategies, Graphics Gems IV. [Haines et al. 2019] Precision improvements for
 * ray/sphere intersection, Ray Tracing Gems. [Newell 1972] in Sutherland, Sproull and Schumacker 1974, A characterization
 * of ten hidden-surface algorithms. [Thürmer and Wüthrich 1998] Computing vertex normals from polygonal facets, Journal of
 * Graphics Tools. [Woop, Benthin and Wald 2013] Watertight ray/triangle intersection, Journal of Computer Graphics
 * Techniques.
 */
package org.diacaustic.shape;
