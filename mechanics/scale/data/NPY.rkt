#lang racket/base
;; Tables in NumPy's format NPY (numpy.lib.format): a head in the syntax of Python that tells the
;; type, the order and the shape of an array, then its numbers as they are in memory.
;;
;; A table is written as an array of records, one for each row, whose fields are the columns.  The
;; number of rows stands in the head and is known only at the end: so room is left for it, and the
;; head is written again.

(require racket/flonum
         racket/list
         racket/string
         "../../error/complain.rkt")

(provide write-NPY
         ;; arrays of numbers, one after the other
         begin-NPY write-number end-NPY plain-type
         ;; columns that are read
         open-NPY (struct-out opened) read-row)

(define magic (bytes-append (bytes #x93) #"NUMPY"))

;; ---------------------------------------------------------------------------
;; Writing

;; names : symbols of the fields; next : -> flvector or #f
(define (write-NPY names next port)
  (define type (record-type names))
  (begin-NPY port type)
  (let loop ([n 0])
    (define row (next))
    (cond [row
           (for ([x (in-flvector row)]) (write-number x port))
           (loop (+ n 1))]
          [else (end-NPY port type n)])))

(define (write-number x port) (void (write-bytes (real->floating-point-bytes x 8 #f) port)))

;; port : of a new file
(define (begin-NPY port type) (void (write-bytes (head-bytes type 0) port)))

(define (end-NPY port type n)
  (file-position port 0)
  (void (write-bytes (head-bytes type n) port)))

(define plain-type "'<f8'")

(define (record-type names)
  (format "[~a]" (string-join (for/list ([name (in-list names)])
                                (format "(~a, ~a)" (Python-text (symbol->string name)) plain-type))
                              ", ")))

(define (Python-text text)
  (format "'~a'" (regexp-replaces text '([#rx"\\\\" "\\\\\\\\"] [#rx"'" "\\\\'"]
                                         [#rx"\n" "\\\\n"]))))

;; Of the same length for any n.  Version 3 has names in UTF-8.
(define (head-bytes type n)
  (define text (format "{'descr': ~a, 'fortran_order': False, 'shape': (~a,), }" type n))
  (define room (- 20 (string-length (number->string n))))
  (define used (+ 12 (bytes-length (string->bytes/utf-8 text)) room 1))
  (define padding (+ room (modulo (- used) 64)))
  (define content
    (bytes-append (string->bytes/utf-8 text) (make-bytes padding (char->integer #\space)) #"\n"))
  (bytes-append magic (bytes 3 0) (integer->integer-bytes (bytes-length content) 4 #f #f) content))

;; ---------------------------------------------------------------------------
;; Reading

;; names : symbols; rows : their number; readers : for each name a procedure that reads the next
;; number of its column
(struct opened (names rows readers) #:authentic)

;; -> the next row of columns that were opened, a list of flonums
(define (read-row o) (for/list ([read (in-list (opened-readers o))]) (read)))

;; open : -> a port that reads the array from its beginning, another one each time
;; base : a text, from which names are made where there are no fields
(define (open-NPY who file open base)
  (define (open-behind-head)
    (define in (open))
    (values in (read-head who file in)))
  (define-values (in head) (open-behind-head))
  (define (part pattern)
    (cadr (or (regexp-match pattern head) (raise-damaged who file))))
  (define type (part #px"'descr': *(\\[.*?\\]|'[^']*'|\"[^\"]*\")"))
  (define shape
    (map string->number (regexp-match* #px"[0-9]+" (part #px"'shape': *\\(([^)]*)\\)"))))
  (define by-columns? (regexp-match? #rx"'fortran_order': *True" head))
  (define (column-port offset)
    (define-values (in _) (open-behind-head))
    (skip! in offset)
    in)
  (cond [(and (regexp-match? #rx"^\\[" type) (= 1 (length shape)))
         (open-records who file in type (car shape))]
        [(memv (length shape) '(1 2))
         (open-array in (reader-of who file type) shape (and by-columns? column-port) base)]
        [else
         (complain who
                   (string-append "expected an array of one or two dimensions"
                                  "\n  file: ~a\n  shape: ~a")
                   file shape)]))

(define (skip! in n)
  (define got (if (> n 0) (read-bytes (min n 65536) in) eof))
  (unless (eof-object? got) (skip! in (- n (bytes-length got)))))

(define (read-head who file in)
  (define beginning (read-bytes 8 in))
  (unless (and (bytes? beginning) (= 8 (bytes-length beginning))
               (equal? magic (subbytes beginning 0 6)))
    (complain who "this is no file in NumPy's format\n  file: ~a" file))
  (define size (if (= 1 (bytes-ref beginning 6)) 2 4))
  (define length (integer-bytes->integer* (read-bytes size in)))
  (define text (and length (read-bytes length in)))
  (unless (bytes? text) (raise-damaged who file))
  (bytes->string/utf-8 text #\?))

(define (integer-bytes->integer* b)
  (and (bytes? b) (for/fold ([n 0]) ([x (in-list (reverse (bytes->list b)))]) (+ (* 256 n) x))))

(define (raise-damaged who file) (complain who "the head of the file is damaged\n  file: ~a" file))

(define (open-records who file in type n)
  (define fields
    (regexp-match* #px"\\((?:'((?:[^'\\\\]|\\\\.)*)'|\"([^\"]*)\"), *('[^']*')\\)" type
                   #:match-select cdr))
  (unless (and (pair? fields) (= (length fields) (length (regexp-match* #rx"\\(" type))))
    (complain who "expected records whose fields are numbers\n  file: ~a\n  type: ~a" file type))
  (opened (for/list ([f (in-list fields)])
            (string->symbol (regexp-replace* #rx"\\\\(.)" (or (car f) (cadr f)) "\\1")))
          n
          (for/list ([f (in-list fields)])
            (define read (car (reader-of who file (caddr f))))
            (lambda () (read in)))))

;; column-port : bytes to pass over -> port; or #f where the array is written row by row
(define (open-array in reader shape column-port base)
  (define n (car shape))
  (define ks (range (if (= 1 (length shape)) 1 (cadr shape))))
  (define-values (read size) (values (car reader) (cdr reader)))
  (opened (for/list ([k (in-list ks)])
            (string->symbol (if (= 1 (length shape)) base (format "~a~a" base k))))
          n
          (for/list ([k (in-list ks)])
            (define p (if column-port (column-port (* k n size)) in))
            (lambda () (read p)))))

;; type : such as '<f8' -> (cons (port -> flonum) size)
(define (reader-of who file type)
  (define m (regexp-match #px"^['\"]([<>|=]?)([fiub])([0-9]+)['\"]$" type))
  (define kind (and m (caddr m)))
  (define size (and m (string->number (cadddr m))))
  (define big? (and m (equal? ">" (cadr m))))
  (define convert
    (cond [(and (equal? kind "f") (memv size '(4 8)))
           (lambda (b) (floating-point-bytes->real b big?))]
          [(and (equal? kind "b") (eqv? size 1)) (lambda (b) (bytes-ref b 0))]
          [(and (member kind '("i" "u")) (memv size '(1 2 4 8)))
           (lambda (b) (integer-bytes->integer b (equal? kind "i") big?))]
          [else
           (complain who "expected numbers that are real\n  file: ~a\n  type: ~a" file type)]))
  (cons (lambda (in)
          (define b (read-bytes size in))
          (unless (and (bytes? b) (= size (bytes-length b)))
            (complain who "the file ends before its last row\n  file: ~a" file))
          (real->double-flonum (convert b)))
        size))
