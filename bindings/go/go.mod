module example.org/vesica

go 1.19
