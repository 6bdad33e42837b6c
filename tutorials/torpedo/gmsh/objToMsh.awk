# Surface of triangles, Wavefront OBJ to gmsh's format 2.2, digits unchanged:
# surface 1, physical group 1
/^v /  { p[++np] = $2 " " $3 " " $4 }
/^f /  {
    ++nf
    split($2, a, "/"); split($3, b, "/"); split($4, c, "/")
    f[nf] = a[1] " " b[1] " " c[1]
}
END {
    print "$MeshFormat\n2.2 0 8\n$EndMeshFormat"
    print "$Nodes"; print np
    for (i = 1; i <= np; ++i) print i, p[i]
    print "$EndNodes\n$Elements"; print nf
    for (i = 1; i <= nf; ++i) print i, 2, 2, 1, 1, f[i]
    print "$EndElements"
}
