/**
 * Spatial indices over plain arrays. They know neither shapes nor photons: they answer which items may lie on a ray or in a
 * ball or in a convex region, and leave the exact question to whoever built them. Start with
 * {@link org.diacaustic.index.BoxHierarchy} for rays, {@link org.diacaustic.index.PointTree} for balls and
 * {@link org.diacaustic.index.BoxTree} for regions.
 *
 * <ul>
 *   <li>[Wald 2007] I. Wald, On fast construction of SAH-based bounding volume hierarchies.
 *   <li>[Ize 2013] T. Ize, Robust BVH ray traversal.
 * </ul>
 */
package org.diacaustic.index;
