# SPDX-License-Identifier: Apache-2.0
# For gtkwave -S: prints what GTKWave has loaded, a line each: the changes of signals; of rows, too, as they are shown, with
# the value under the marker at the time $env(MARKER); the end. (A name's range is lost in signalChangeList.)
proc changes {kind name} {
  puts "CHANGES\t$kind\t$name\t[gtkwave::signalChangeList $name]"
}
for {set i 0} {$i < [gtkwave::getNumFacs]} {incr i} {
  changes signal [gtkwave::getFacName $i]
}
gtkwave::setMarker $env(MARKER)
gtkwave::nop
for {set i 0} {$i < [gtkwave::getTotalNumTraces]} {incr i} {
  set name [gtkwave::getTraceNameFromIndex $i]
  puts "ROW\t$name\t[gtkwave::getTraceValueAtMarkerFromIndex $i]"
  changes row $name
}
puts "END\t[gtkwave::getMaxTime]"
exit
