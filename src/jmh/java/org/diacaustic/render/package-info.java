/** Benchmarks of the eye pass, beside the code they measure. */
package org.diacaustic.render;
