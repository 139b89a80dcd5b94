#lang racket/base
;; Tables in files: what was written is read again, by us and by NumPy.

(require mechanics
         racket/file
         (only-in racket/flonum ->fl)
         racket/string
         "../../support/checks.rkt" "../../support/folder.rkt" "../../support/python.rkt"
         "../../support/skip.rkt")

(define formats '("a.csv" "a.npy" "a.npz"))
(define plane (up 0 (up 1/3 2) (down 3 4e-300)))
(define odd (up 1 (up 1e21 +nan.0) (down +inf.0 -inf.0)))

(define (circle s) (up 1 (ref s 2) (- (ref s 1))))
(define turn (evolve-trajectory circle (up 0 1.0 0.0) 6))

(define (exact->inexact* s) (s:map/r exact->inexact s))

(define-syntax-rule (in-each-format (file) body ...)
  (with-folder (folder)
    (for ([name (in-list formats)])
      (define file (build-path folder name))
      body ...)))

(test-case "states come back to the last digit, with names of their variables"
  (in-each-format (file)
    (write-table (list plane odd) file)
    (define t (read-table file))
    (check-equal? (table-names t) '(t q0 q1 p0 p1))
    (check-equal? (table-length t) 2)
    (check-equal? (table-column t 'q0) '(0.3333333333333333 1e21))
    (check-equal? (table-column t "q1") '(2.0 +nan.0))
    (check-equal? (table-rows t plane) (map exact->inexact* (list plane odd)))
    (check-equal? (table-names (read-table file #:columns '(p1 t))) '(p1 t))
    (check-equal? (table-column (read-table file #:columns '(p1 t)) 't) '(0.0 1.0))))

(test-case "a trajectory is written at the ends of its steps, or at times"
  (in-each-format (file)
    (write-table turn file)
    (check-equal? (table-rows (read-table file) (up 't 'q 'v)) (trajectory-states turn))
    (write-table turn file #:times '(1 2) #:names '(t x "speed, m"))
    (check-equal? (table-names (read-table file)) '(t x |speed, m|))
    (check-equal? (table-rows (read-table file) (up 't 'q 'v)) (trajectory-states turn '(1 2)))))

(test-case "the time is the first column where the state does not tell it"
  (in-each-format (file)
    (define decay (evolve-trajectory (lambda (s) (up (- (ref s 0)))) (up 1.0) 2))
    (write-table decay file #:times '(0 2))
    (check-equal? (table-rows (read-table file)) (list (up 0.0 1.0) (up 2.0 (ref (decay 2) 0))))
    (check-equal? (table-names (read-table file)) '(t x0))))

(test-case "occurrences, failures of an ensemble, numbers and lists are rows"
  (in-each-format (file)
    (define (written rows) (write-table rows file) (table-rows (read-table file)))
    (define crossings
      (trajectory-events (evolve-trajectory circle (up 0 1.0 0.0) 6
                                            #:events (event (lambda (s) (ref s 1))))))
    (check-equal? (table-rows (begin (write-table crossings file) (read-table file)) (up 't 'q 'v))
                  (map occurrence-state crossings))
    (define ends
      (evolve-ensemble (lambda (s) (up 1 (/ 1 (ref s 1)))) (list (up 0 0.0) (up 0 1.0)) 1 #:jobs 1))
    (define-values (failed end) (apply values ends))
    (check-equal? (written ends) (list (up +nan.0 +nan.0) end))
    (check-equal? (written (list end failed end)) (list end (up +nan.0 +nan.0) end))
    (check-equal? (table-names (read-table file)) '(x0 x1))
    (check-equal? (written '(1 2.5)) (list (up 1.0) (up 2.5)))
    (check-equal? (written '((1 2) (3 4))) (list (up 1.0 2.0) (up 3.0 4.0)))
    (check-equal? (written (list (build-list 50 values))) (list (apply up (build-list 50 ->fl))))
    (check-equal? (begin (write-table (list (list 1 2 3)) file) (table-names (read-table file)))
                  '(x0 x1 x2))
    (write-table '() file #:names '(a b))
    (check-equal? (table-length (read-table file)) 0)))

(test-case "semicolons and decimal commas are read"
  (with-folder (folder)
    (define file (build-path folder "a.csv"))
    (define (columns text #:names [names #f])
      (display-to-file text file #:exists 'truncate)
      (define t (read-table file #:names names))
      (list (table-column t 't) (table-column t 'x)))
    (define expected '((0.0 0.5) (1.5 -2000.0)))
    (check-equal? (columns "t;x\n0;1,5\n0,5;-2,0e3\n") expected)
    (check-equal? (columns "t\tx\n0\t1,5\n0,5\t-2e3\n") expected)
    (check-equal? (columns "t;x\n0;1.5\n0.5;-2000\n") expected)
    (check-equal? (columns "0;1,5\n0,5;-2000\n" #:names '(t x)) expected)))

(test-case "a table is written again in another format"
  (with-folder (folder)
    (define-values (a b) (values (build-path folder "a.csv") (build-path folder "b.npz")))
    (write-table turn a)
    (write-table (read-table a) b)
    (check-equal? (read-table b) (read-table a))
    (check-equal? (format "~a" (read-table b))
                  (format "table of ~a rows: t, q, v" (length (trajectory-states turn))))))

(test-case "an array's head tells how many rows there are"
  (with-folder (folder)
    (define file (build-path folder "a.npy"))
    (write-table '((1 2) (3 4)) file)
    (check-true (regexp-match? #rx#"^.NUMPY.*'shape': [(]2,[)]" (file->bytes file)))))

;; ---------------------------------------------------------------------------
;; RFC 4180

(define (read-text text . options)
  (with-folder (folder)
    (define file (build-path folder "a.csv"))
    (call-with-output-file file (lambda (out) (write-string text out)))
    (read-table file)))

(test-case "text as RFC 4180 has it"
  (with-folder (folder)
    (define file (build-path folder "a.csv"))
    (write-table '((1 2)) file #:names '("a,b" "say \"x\""))
    (check-equal? (file->string file) "\"a,b\",\"say \"\"x\"\"\"\r\n1.0,2.0\r\n")
    (check-equal? (table-names (read-table file)) '(|a,b| |say "x"|))))

(test-case "what other programs write is read"
  (check-equal? (table-rows (read-text "\uFEFFt, q\n1,+.5\n\n2., -3E2\n"))
                (list (up 1.0 0.5) (up 2.0 -300.0)))
  (check-equal? (table-names (read-text "\"two\nlines\",q\r1,2\r"))
                (list (string->symbol "two\nlines") 'q))
  (check-equal? (table-rows (read-text "t,q\r\n\"1\",NaN\r\n-inf,Infinity"))
                (list (up 1.0 +nan.0) (up -inf.0 +inf.0))))

;; ---------------------------------------------------------------------------
;; Row by row

(define many 60000)              ; kept, they would take twice what is allowed below
(define (rows) (in-producer (counter) #f))
(define (counter)
  (define k 0)
  (lambda ()
    (set! k (+ k 1))
    (and (<= k many) (list k (* 0.5 k)))))

(test-case "any number of rows takes the same memory, written and read"
  (define (used)
    (collect-garbage)
    (current-memory-use))
  (in-each-format (file)
    (define before (used))
    (write-table (rows) file #:names '(a b))
    (define-values (count at-end)
      (apply values
             (read-table file #:initial (list 0 0)
                         #:fold (lambda (row so-far)
                                  (define k (+ 1 (car so-far)))
                                  (list k (if (= k many) (used) 0))))))
    (check-equal? count many)
    (check < (- at-end before) 2e6)))

;; ---------------------------------------------------------------------------
;; NumPy

;; NPY, version 1.0: the length of the head, the head, then the numbers
(define (write-NPY file type by-columns? shape numbers)
  (define head
    (format "{'descr': '~a', 'fortran_order': ~a, 'shape': ~a, }\n"
            type (if by-columns? "True" "False") shape))
  (call-with-output-file file
    (lambda (out)
      (write-bytes (bytes-append #"\223NUMPY\1\0"
                                 (integer->integer-bytes (string-length head) 2 #f #f)
                                 (string->bytes/latin-1 head)
                                 (apply bytes-append numbers))
                   out))))

(test-case "an array column by column, of short integers; one row by row, of big-endian numbers"
  (define (short n) (integer->integer-bytes n 2 #f #f))
  (define (big x) (real->floating-point-bytes x 8 #t))
  (with-folder (folder)
    (define (rows type by-columns? shape numbers)
      (define file (build-path folder (format "~a.npy" (substring type 1))))
      (write-NPY file type by-columns? shape numbers)
      (table-rows (read-table file)))
    (check-equal? (rows "<u2" #t "(3, 2)" (map short '(1 3 5 2 4 6)))
                  (list (up 1.0 2.0) (up 3.0 4.0) (up 5.0 6.0)))
    (check-equal? (rows "|i1" #f "(2,)" '(#"\377" #"\1")) (list (up -1.0) (up 1.0)))
    (check-equal? (rows ">f8" #f "(2, 2)" (map big '(1.5 2.5 -3.0 4.0)))
                  (list (up 1.5 2.5) (up -3.0 4.0)))))

(define python (python-with "numpy"))

(define loading #<<end
import numpy as np, warnings
warnings.simplefilter('ignore')
a = np.load('a.npy'); z = np.load('a.npz')
c = np.genfromtxt('a.csv', delimiter=',', names=True)
for x in (a, c): print(list(x.dtype.names), x['q'].tolist() == z['q'].tolist(), float(x['v'][-1]))
print(z.files)
np.savez('b.npz', t=np.arange(3.), q=np.array([[1, 2], [3, 4], [5, 6]], dtype='>i4'))
np.savez_compressed('c.npz', q=np.asfortranarray(np.array([[1, 2], [3, 4]], dtype='f4')))
np.save('d.npy', np.asfortranarray(np.array([[1, 2], [3, 4], [5, 6]], dtype='u2')))
np.save('e.npy', np.array([(1, 2.5), (3, 4.5)], dtype=[('a', 'i2'), ("b'θ", 'f8')]))
np.save('f.npy', np.array([True, False]))
end
  )

(skip-unless python "a Python with NumPy: files as it reads and writes them"
  (with-folder (folder)
    (define (in-folder name) (build-path folder name))
    (for ([name (in-list formats)]) (write-table turn (in-folder name)))
    (define said (run-python python folder loading))
    (test-case "NumPy loads what is written"
      (define line (format "['t', 'q', 'v'] True ~a" (ref (trajectory-final-state turn) 2)))
      (check-equal? (string-split said "\n") (list line line "['t', 'q', 'v']")))
    (test-case "what NumPy saves is read"
      (define (read name)
        (define t (read-table (in-folder name)))
        (cons (table-names t) (table-rows t)))
      (check-equal? (read "b.npz")
                    (list '(t q0 q1) (up 0.0 1.0 2.0) (up 1.0 3.0 4.0) (up 2.0 5.0 6.0)))
      (check-equal? (read "c.npz") (list '(q0 q1) (up 1.0 2.0) (up 3.0 4.0)))
      (check-equal? (read "d.npy") (list '(x0 x1) (up 1.0 2.0) (up 3.0 4.0) (up 5.0 6.0)))
      (check-equal? (read "e.npy") (list '(a |b'θ|) (up 1.0 2.5) (up 3.0 4.5)))
      (check-equal? (read "f.npy") (list '(x) (up 1.0) (up 0.0))))))
