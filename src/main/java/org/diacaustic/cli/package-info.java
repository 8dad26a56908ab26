/**
 * The command line: commands, exit codes, the progress line. Only this package prints. Start reading at {@link
 * org.diacaustic.cli.Main}.
 */
package org.diacaustic.cli;
