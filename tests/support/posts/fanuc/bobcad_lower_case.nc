%
o100 (bobcad)
n01 g00 g17 g40 g49 g80 g90
n02 g21
n03	t1 m06
n04	g54 g90 s3000 m03
n05	g00 x0. y-15.
n06	g43 h1 z25. m08
n07	g01 z-1. f200.
n08	g42 d1 y0. f400.
n09	x-30.
n10	g40 y-15.
n11	g00 z25.
n12	m09
n13	m05
n14	g91 g28 z0.
n15	g28 x0. y0.
n16	m30
%
