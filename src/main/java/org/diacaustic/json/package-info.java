/** Text for other programs: JSON. Start reading at {@link org.diacaustic.json.JsonWriter}. */
package org.diacaustic.json;
