/**
 * Where the light that the forward pass brings is kept, and how it is read again: photons in primitive arrays, triangles
 * of light, maps over them. This package takes numbers (points, normals, object numbers, powers) and knows no scene. Start reading at
 * {@link org.diacaustic.map.IlluminationMap}. Photons go from {@link org.diacaustic.map.PhotonSlice} to
 * {@link org.diacaustic.map.PhotonStore} to {@link org.diacaustic.map.PhotonTree}, which
 * {@link org.diacaustic.map.PhotonMap} reads. Cells of light go from {@link org.diacaustic.map.CellSlice} to
 * {@link org.diacaustic.map.CellStore} to {@link org.diacaustic.map.CausticMesh}, which is asked about a
 * {@link org.diacaustic.map.Footprint}. A mesh whose cells have kept their {@link org.diacaustic.map.CellSeed} can be asked
 * about points exactly, by one who follows {@link org.diacaustic.map.LightPaths} for it.
 *
 * <ul>
 *   <li>[Thesis] H. A. Bailey, 1999; 4.5 to 4.8 for photon maps.
 *   <li>[García et al. 2012] R. García, C. Ureña, M. Sbert, Description and solution of an unreported intrinsic bias in
 *       photon mapping density estimation with constant kernel.
 *   <li>[García et al. 2014] R. García, C. Ureña, J. Poch, M. Sbert, Overestimation and underestimation biases in photon mapping
 *       with non-constant kernels.
 *   <li>[Jensen 1996] H. W. Jensen, Global illumination using photon maps.
 *   <li>[Knaus and Zwicker 2011] C. Knaus, M. Zwicker, Progressive photon mapping: a probabilistic approach.
 *   <li>[Mitchell and Hanrahan 1992] D. Mitchell, P. Hanrahan, Illumination from curved reflectors.
 *   <li>[Meyer et al. 2010] Q. Meyer, J. Süßmuth, G. Sußner, M. Stamminger, G. Greiner, On floating-point normal vectors.
 *   <li>[Roberts 2018] M. Roberts, The unreasonable effectiveness of quasirandom sequences.
 *   <li>[Silverman 1986] B. W. Silverman, Density estimation for statistics and data analysis.
 *   <li>[Sutherland and Hodgman 1974] I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping.
 *   <li>[Tricomi and Erdélyi 1951] F. Tricomi, A. Erdélyi, The asymptotic expansion of a ratio of gamma functions.
 * </ul>
 */
package org.diacaustic.map;
