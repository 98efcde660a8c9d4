(A slot with a round end, cut by an end mill of 6 mm in two passes)
G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G1 X30 F600
G3 X30 Y20 I0 J10
G1 X0
G1 Z-4 F200
G1 X30 F600
G2 X30 Y0 I0 J-10
G1 X0
G0 Z5
M30
