/**
 * The scene as data, and the scene arranged for rays: objects, camera, settings, the media a ray is in. Start reading at
 * {@link org.diacaustic.scene.Scene}.
 */
package org.diacaustic.scene;
