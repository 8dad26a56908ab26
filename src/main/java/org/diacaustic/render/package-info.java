/**
 * From a scene to a picture: the plan that says what runs and what is left out, the eye pass, tiles on all cores. Start
 * reading at {@link org.diacaustic.render.Renderer}.
 */
package org.diacaustic.render;
